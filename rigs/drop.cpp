// SPDX-License-Identifier: MIT
#include "rigs/drop.hpp"

#include "rigs/physics.hpp"
#include "rigs/single_grain.hpp"
#include "scaling/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigs {
namespace {

using scaling::InvalidParameter;
using scaling::mistake;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

DropWorld world_of(const DropSetup& s) {
    return {s.grain, nullptr, s.numerics ? &*s.numerics : nullptr};
}

class Drop : public ForwardModel {
  public:
    explicit Drop(const cases::Experiment& e) : stated_(e) {}

    Curves predict(const World& world, const Ordinates& o) const override {
        return curves(world, o,
                      {{"z", [](const DropState& s) { return s.z; }},
                       {"x", [](const DropState& s) { return s.x; }}});
    }
    Curves variables(const World& world, const Ordinates& o) const override {
        return curves(world, o,
                      {{"t", [](const DropState& s) { return s.t; }},
                       {"z", [](const DropState& s) { return s.z; }},
                       {"speed", [](const DropState& s) { return s.speed(); }},
                       {"impact_speed", [](const DropState& s) { return s.impact_speed; }}});
    }
    std::set<std::string> effects() const override { return drop_effects(); }

  private:
    using Channel = std::pair<const char*, double (*)(const DropState&)>;
    Stated stated_;

    Curves curves(const World& world, const Ordinates& o,
                  const std::vector<Channel>& channels) const {
        check_missing(world, "drop", {"t", "z", "speed", "impact_speed"});
        const OneGrain grain = one_grain(stated_, world);
        const InOrder times(o.at);
        const DropPath path = follow_drop({grain, world.missing ? &*world.missing : nullptr,
                                           world.numerics ? &*world.numerics : nullptr},
                                          drop_conditions(stated_, world), times.at);
        Curves result;
        for (const auto& [name, value] : channels) {
            std::vector<double>& curve = result[name];
            curve.assign(o.at.size(), nothing);
            for (std::size_t k = 0; k < path.states.size(); ++k)
                curve[times.from[k]] = value(path.states[k]);
        }
        return result;
    }
};

}  // namespace

std::set<std::string> drop_effects() {
    return {"gravity",
            "hertz_mindlin",
            "hertz_coulomb",
            "adhesion",
            "van_der_waals",
            "capillary_bridge",
            "electrostatic",
            "air_drag",
            "buoyancy",
            "rolling_resistance",
            "viscoelastic_restitution",
            "plastic_restitution",
            "velocity_dependent_friction",
            "tangential_compliance",
            "tilt",
            "vibration"};
}

void refuse_physics_of_many(const cases::Case& c, const std::string& rig) {
    const std::set<std::string> known =
        drop_effects();  // every effect on one grain shows in a drop
    refuse_other_physics(c, rig, {known.begin(), known.end()});
}

std::unique_ptr<ForwardModel> drop_model(const cases::Experiment& e) {
    return std::make_unique<Drop>(e);
}

DropConditions drop_conditions(const Stated& stated, const World& world) {
    return {.height = stated.value(world, "conditions.height"),
            .speed = stated.value(world, "conditions.speed", 0.0),
            .horizontal_speed = stated.value(world, "conditions.horizontal_speed", 0.0),
            .spin = stated.value(world, "conditions.spin", 0.0),
            .release_time = stated.value(world, "conditions.release_time", 0.0)};
}

DropSetup drop_setup(const cases::Case& c, const cases::Experiment& experiment) {
    refuse_physics_of_many(c, "drop");
    const World world = rigs::world_of(c, experiment);
    const Stated stated(experiment);
    return {drop_conditions(stated, world), one_grain(stated, world), world.numerics};
}

DropRecord run_drop(const DropSetup& setup, const std::vector<double>& times) {
    if (!std::is_sorted(times.begin(), times.end()))
        throw InvalidParameter(mistake("run_drop.times", "a time before the one in front of it",
                                       "must not fall", "sort them"));
    const DropPath path = follow_drop(world_of(setup), setup.conditions, times);
    DropRecord record{.t = {},
                      .z = {},
                      .x = {},
                      .settled = path.settled,
                      .settled_at = path.settled_at,
                      .impacts = path.impacts,
                      .steps = path.steps};
    for (const DropState& s : path.states)
        record.t.push_back(s.t), record.z.push_back(s.z), record.x.push_back(s.x);
    return record;
}

DropRecord run_drop(const DropSetup& setup, int count) {
    const DropConditions& c = setup.conditions;
    const DropWorld world = world_of(setup);
    const double g = world.into, square = c.speed * c.speed + 2.0 * g * c.height;
    if (!(g > 0.0 || c.speed > 0.0))
        throw InvalidParameter(mistake("run_drop.times", "none",
                                       "must be given for a grain that never falls",
                                       "gravity is 0 and it does not move towards the plate"));
    const double fall =
        g > 0.0 ? (std::sqrt(std::max(0.0, square)) - c.speed) / g : c.height / c.speed;
    // A grain at the plate settles within some sqrt(R/g); hence the second term.
    const double rest = g > 0.0 ? std::sqrt(setup.grain.radius / g) : fall;
    const double longest = c.release_time + 20.0 * (fall + rest);
    const DropRecord scout = run_drop(setup, std::vector<double>{longest});
    const double end = scout.settled ? scout.settled_at : longest;
    std::vector<double> times;
    for (int k = 0; k < count; ++k) times.push_back(end * k / std::max(1, count - 1));
    return run_drop(setup, times);
}

}  // namespace rigs
