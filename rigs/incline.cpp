// SPDX-License-Identifier: MIT
// The rig `incline`: one grain that slides or rolls on a plane (docs/incline.md).
#include "rigs/on_plate.hpp"
#include "rigs/single_grain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigs {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

class Incline : public ForwardModel {
  public:
    explicit Incline(const cases::Experiment& e) : stated_(e) {}

    Curves predict(const World& world, const Ordinates& o) const override {
        const auto [states, radius] = run(world, o);
        Curves c;
        put(c["s"], states, [](const OnPlate& x) { return x.s; });
        put(c["spin"], states, [r = radius](const OnPlate& x) { return x.w / r; });
        return c;
    }
    Curves variables(const World& world, const Ordinates& o) const override {
        const auto [states, radius] = run(world, o);
        Curves c;
        put(c["t"], states, [](const OnPlate& x) { return x.t; });
        put(c["s"], states, [](const OnPlate& x) { return x.s; });
        put(c["speed"], states, [](const OnPlate& x) { return x.v; });
        put(c["spin"], states, [r = radius](const OnPlate& x) { return x.w / r; });
        put(c["slip"], states, [](const OnPlate& x) { return x.v - x.w; });
        return c;
    }
    std::set<std::string> effects() const override { return incline_effects(); }

  private:
    struct Run {
        std::vector<OnPlate> states;  // [ordinates]
        double radius;
    };
    Stated stated_;

    template <class Value>
    static void put(std::vector<double>& to, const std::vector<OnPlate>& states, Value value) {
        to.reserve(states.size());
        for (const OnPlate& x : states) to.push_back(value(x));
    }

    static double variable(const std::string& name, const OnPlate& x, double radius) {
        if (name == "t") return x.t;
        if (name == "s") return x.s;
        if (name == "speed") return x.v;
        return name == "spin" ? x.w / radius : x.v - x.w;
    }

    Run run(const World& world, const Ordinates& o) const {
        check_missing(world, "incline", {"t", "s", "speed", "spin", "slip"});
        const OneGrain g = one_grain(stated_, world);
        const double angle = stated_.value(world, "conditions.angle") + g.tilt_angle;
        const double held = (g.attraction.in_contact() + 2.0 * g.pull_off_force()) / g.mass;
        PlateForces forces{.along = g.gravity * std::sin(angle),
                           .press = g.gravity * std::cos(angle) + held,
                           .friction = g.friction,
                           .rolling_friction = g.rolling_friction,
                           .drag = &g.drag,
                           .mass = g.mass,
                           .further = {}};
        if (world.missing)
            forces.further = [&m = *world.missing, r = g.radius](const OnPlate& x) {
                return straight_between(m.knots, m.newtons, variable(m.variable, x, r));
            };
        OnPlate x{0.0, 0.0, stated_.value(world, "conditions.speed", 0.0),
                  g.radius * stated_.value(world, "conditions.spin", 0.0)};
        const InOrder times(o.at);
        Run result{std::vector<OnPlate>(o.at.size(), {nothing, nothing, nothing, nothing}),
                   g.radius};
        Rows rows{times.at};
        const auto record = [&](std::size_t row, const OnPlate& at) {
            OnPlate& kept = result.states[times.from[row]];
            kept = at, kept.t = times.at[row];
        };
        for (; !rows.done() && rows.time() <= 0.0; ++rows.next) record(rows.next, x);
        carry(x, std::numeric_limits<double>::infinity(), forces, rows, record);
        return result;
    }
};

}  // namespace

std::set<std::string> incline_effects() {
    return {"gravity",
            "hertz_mindlin",
            "hertz_coulomb",
            "air_drag",
            "buoyancy",
            "adhesion",
            "capillary_bridge",
            "electrostatic",
            "rolling_resistance",
            "velocity_dependent_friction",
            "tilt"};
}

std::unique_ptr<ForwardModel> incline_model(const cases::Experiment& e) {
    return std::make_unique<Incline>(e);
}

}  // namespace rigs
