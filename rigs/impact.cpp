// SPDX-License-Identifier: MIT
// The rig `impact`: one grain thrown at a plate under many angles (docs/impact.md). A contact alone: no weight, no air.
#include "rigs/drop_path.hpp"
#include "rigs/one_contact.hpp"
#include "rigs/single_grain.hpp"
#include "scaling/errors.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace rigs {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

struct Thrown {
    double normal, v, w;  // m/s, away from the plate, along it, R spin
};

// The contact as a run at a fixed step made it.
Thrown stepped(const OneGrain& g, const cases::Numerics& numerics, const Approach& in) {
    const double step = numerics.time_step->value();
    const DropConditions c{.height = 1.5 * step * in.normal,
                           .speed = in.normal,
                           .horizontal_speed = in.v,
                           .spin = in.w / g.radius,
                           .release_time = 0.0};
    // Hertz' impact lasts 2.94 times its depth over its speed; ten of them, and at least some steps.
    const double depth = std::pow(
        1.25 * g.mass * in.normal * in.normal / (4.0 / 3.0 * g.e_star * std::sqrt(g.radius)), 0.4);
    const double end = 30.0 * depth / in.normal + 10.0 * step;
    const DropState s = follow_drop({g, nullptr, &numerics}, c, {end}).states.front();
    return {s.vz, s.vx, s.w};
}

class Impact : public ForwardModel {
  public:
    explicit Impact(const cases::Experiment& e) : stated_(e) {}

    Curves predict(const World& world, const Ordinates& o) const override {
        if (world.missing)
            throw scaling::InvalidInput(scaling::mistake(
                "missing force on impact", world.missing->variable, "must not be asked for",
                "a contact is too short for a force that no law explains"));
        const OneGrain g = contact_alone(world);
        const double speed = stated_.value(world, "conditions.speed");
        const double spin = stated_.value(world, "conditions.spin", 0.0);
        const bool steps = world.numerics && world.numerics->time_step;
        OneContact contact(g);
        Curves c;
        std::vector<double>&rebound = c["rebound_angle"], &normal = c["normal_restitution"],
        &tangential = c["tangential_restitution"], &spun = c["rebound_spin"];
        for (auto* curve : {&rebound, &normal, &tangential, &spun})
            curve->assign(o.at.size(), nothing);
        for (std::size_t i = 0; i < o.at.size(); ++i) {
            const double angle = o.at[i];
            if (!(std::abs(angle) < 0.5 * std::numbers::pi)) continue;
            const Approach in{speed * std::cos(angle), speed * std::sin(angle), g.radius * spin};
            Thrown out{};
            if (steps) {
                out = stepped(g, *world.numerics, in);
            } else {
                const Rebound r = contact.touch(in);
                out = {r.normal, r.v, r.w};
            }
            rebound[i] = std::atan2(out.v, out.normal);
            normal[i] = out.normal / in.normal;
            if (in.v != 0.0) tangential[i] = out.v / in.v;
            spun[i] = out.w / g.radius;
        }
        return c;
    }
    Curves variables(const World& world, const Ordinates& o) const override {
        const double speed = stated_.value(world, "conditions.speed");
        Curves c{{"angle", o.at}, {"normal_speed", o.at}};
        for (double& v : c["normal_speed"]) v = speed * std::cos(v);
        return c;
    }
    std::set<std::string> effects() const override { return impact_effects(); }

  private:
    Stated stated_;

    // Only what acts in a contact of microseconds (docs/effects.md).
    OneGrain contact_alone(const World& world) const {
        World w{.physics = {},
                .parameters = world.parameters,
                .stated = world.stated,
                .numerics = world.numerics,
                .missing = {},
                .missing_restitution = world.missing_restitution};
        const std::set<std::string> known = impact_effects();
        for (const std::string& name : world.physics)
            if (known.count(name) > 0) w.physics.insert(name);
        return one_grain(stated_, w);
    }
};

}  // namespace

std::set<std::string> impact_effects() {
    return {"hertz_mindlin",        "hertz_coulomb",
            "rolling_resistance",   "viscoelastic_restitution",
            "plastic_restitution",  "velocity_dependent_friction",
            "tangential_compliance"};
}

std::unique_ptr<ForwardModel> impact_model(const cases::Experiment& e) {
    return std::make_unique<Impact>(e);
}

}  // namespace rigs
