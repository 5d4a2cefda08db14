// SPDX-License-Identifier: MIT
#include "tests/contact/rows.hpp"

#include "contact/ageing.hpp"
#include "contact/capillary_bridge.hpp"
#include "contact/coulomb.hpp"
#include "contact/damping.hpp"
#include "contact/drag_schiller1935.hpp"
#include "contact/friction_cap.hpp"
#include "contact/hertz.hpp"
#include "contact/jkr.hpp"
#include "contact/mindlin.hpp"
#include "contact/rolling_edem_standard.hpp"
#include "contact/rolling_epsd.hpp"
#include "contact/rolling_rvd.hpp"
#include "contact/rolling_sds.hpp"
#include "contact/twisting_marshall2009.hpp"

#include <limits>

double State::operator()(const std::string& name) const {
    for (const Quantity& q : inputs)
        if (q.name == name) return q.value;
    return std::numeric_limits<double>::quiet_NaN();
}

contact::Vec3 State::vector(const std::string& name) const {
    return {(*this)(name + ".x"), (*this)(name + ".y"), (*this)(name + ".z")};
}

namespace {

using contact::Vec3;
using Quantities = std::vector<Quantity>;

constexpr Dimension one{0, 0, 0}, metre{0, 1, 0}, second{0, 0, 1}, kilogram{1, 0, 0};
constexpr Dimension cubic_metre{0, 3, 0};
constexpr Dimension newton{1, 1, -2}, joule{1, 2, -2}, pascal{1, -1, -2};
constexpr Dimension metre_per_second{0, 1, -1}, per_second{0, 0, -1};
constexpr Dimension newton_per_metre{1, 0, -2}, kilogram_per_second{1, 0, -1};
constexpr Dimension kilogram_per_cubic_metre{1, -3, 0}, pascal_second{1, -1, -1};
constexpr Dimension per_inertia{-1, -2, 0};       // 1/(kg m^2)
constexpr Dimension per_metre_second{0, -1, -1};  // 1/(m s)

void add(Quantities& to, const std::string& name, Dimension dimension, Vec3 v) {
    to.push_back({name + ".x", dimension, v.x});
    to.push_back({name + ".y", dimension, v.y});
    to.push_back({name + ".z", dimension, v.z});
}

template <class Law>
Quantities normal_response(const Law& law, double r_star, double overlap) {
    const double scale = law.length_scale(r_star);
    const contact::NormalState state = law.at(r_star, scale, overlap);
    return {{"force", newton, state.force},
            {"contact_radius", metre, state.contact_radius},
            {"energy", joule, law.energy(r_star, scale, overlap)}};
}

Row hertz() {
    return {.law = "Hertz",
            .states = {{{{"e_star", pascal, 3.1e9},
                         {"r_star", metre, 6.3e-5},
                         {"overlap", metre, 2.7e-8}}}},
            .evaluate = [](const State& x) {
                return normal_response(contact::Hertz{x("e_star")}, x("r_star"), x("overlap"));
            }};
}

Row jkr() {
    const auto state = [](double overlap) {
        return State{{{"e_star", pascal, 3.1e9},
                      {"w", newton_per_metre, 0.07},
                      {"r_star", metre, 6.3e-5},
                      {"overlap", metre, overlap}}};
    };
    return {.law = "Jkr",
            .states = {state(2.7e-8), state(-2e-9)},  // pressed; stretched, tear-off at -5.1e-9
            .evaluate = [](const State& x) {
                const contact::Jkr fold{.e_star = x("e_star"), .w = x("w")};
                const contact::Jkr dead_load{x("e_star"), x("w"), contact::TearOff::max_tension};
                const double r_star = x("r_star"), scale = fold.length_scale(r_star);
                Quantities out = normal_response(fold, r_star, x("overlap"));
                out.push_back({"pull_off_force", newton, fold.pull_off_force(r_star)});
                out.push_back({"fold", metre, fold.tear_off_overlap(r_star, scale)});
                out.push_back({"max_tension", metre, dead_load.tear_off_overlap(r_star, scale)});
                return out;
            }};
}

Row capillary_bridge() {
    const auto state = [](double gap) {
        return State{{{"surface_tension", newton_per_metre, 0.072},
                      {"volume", cubic_metre, 3e-15},
                      {"contact_angle", one, 0.3},
                      {"r_star", metre, 6.3e-5},
                      {"gap", metre, gap}}};
    };
    return {.law = "CapillaryBridge",
            .states = {state(2e-6), state(2e-5)},  // held; ruptured, at 1.7e-5
            .evaluate = [](const State& x) {
                const auto law = contact::CapillaryBridge::from(
                    scaling::in_si<scaling::EnergyPerArea>(x("surface_tension")),
                    scaling::in_si<scaling::Volume>(x("volume")), x("contact_angle"));
                return Quantities{{"closed", newton, law.closed(x("r_star"))},
                                  {"across", newton, law.across(x("r_star"), x("gap"))},
                                  {"work", joule, law.work(x("r_star"), x("gap"))},
                                  {"rupture_gap", metre, law.rupture_gap}};
            }};
}

Row ageing() {
    return {.law = "Ageing",
            .states = {{{{"rate", one, 0.3},
                         {"onset", second, 0.2},
                         {"age", second, 7.0},
                         {"w", newton_per_metre, 0.07}}}},
            .evaluate = [](const State& x) {
                const contact::Ageing law{x("rate"), x("onset")};
                const contact::Jkr fresh{.e_star = 1.0, .w = x("w")};
                return Quantities{{"w", newton_per_metre, law.aged(fresh, x("age")).w}};
            }};
}

Row damping() {
    return {.law = "DampingTsuji1992",
            .states = {{{{"factor", one, 0.4},
                         {"e_star", pascal, 3.1e9},
                         {"g_star", pascal, 0.9e9},
                         {"contact_radius", metre, 1.3e-6},
                         {"m_star", kilogram, 4.4e-9}}}},
            .evaluate = [](const State& x) {
                const contact::DampingTsuji1992 law{x("factor")};
                const double a = x("contact_radius"), m_star = x("m_star");
                return Quantities{
                    {"normal", kilogram_per_second, law.normal(x("e_star"), a, m_star)},
                    {"tangential", kilogram_per_second, law.tangential(x("g_star"), a, m_star)}};
            }};
}

Row viscoelastic() {
    return {.law = "Damping",
            .states = {{{{"factor", one, 0.4},
                         {"eta", per_metre_second, 3e9},
                         {"tangential_ratio", one, 0.7},
                         {"e_star", pascal, 3.1e9},
                         {"contact_radius", metre, 1.3e-6},
                         {"m_star", kilogram, 4.4e-9}}}},
            .evaluate = [](const State& x) {
                contact::Damping law = contact::DampingTsuji1992{x("factor")};
                law.viscoelastic = {x("eta"), x("tangential_ratio")};
                const double a = x("contact_radius"), m_star = x("m_star");
                return Quantities{
                    {"normal", kilogram_per_second, law.normal(x("e_star"), a, m_star)},
                    {"tangential", kilogram_per_second, law.viscoelastic.tangential(a, m_star)}};
            }};
}

Row friction_cap() {
    return {.law = "cap_force",
            .states = {{{{"elastic", newton, 3e-4},
                         {"damping", newton, -1e-4},
                         {"pull_off", newton, 2e-4},
                         {"e_star", pascal, 3.1e9},
                         {"r_star", metre, 6.3e-5},
                         {"contact_radius", metre, 1.3e-6}}}},
            .evaluate = [](const State& x) {
                using enum contact::FrictionCap;
                const auto with = [&](contact::FrictionCap cap) {
                    return contact::cap_force(
                        cap, x("elastic"), x("damping"), x("pull_off"),
                        contact::repulsive_force(x("e_star"), x("r_star"), x("contact_radius")));
                };
                return Quantities{{"elastic", newton, with(elastic_plus_two_pull_off)},
                                  {"total", newton, with(total_plus_two_pull_off)},
                                  {"repulsive", newton, with(repulsive_part)},
                                  {"bare", newton, with(elastic)}};
            }};
}

// Unit normal; slip_velocity below lies in its plane.
constexpr Vec3 normal{0.36, 0.48, 0.8};

contact::TangentialInput tangential_input(const State& x) {
    return {.spring = x.vector("spring"),
            .previous_radius = x("previous_radius"),
            .contact_radius = x("contact_radius"),
            .n = x.vector("n"),
            .slip_velocity = x.vector("slip_velocity"),
            .cap_force = x("cap_force"),
            .damping_factor = x("damping_factor"),
            .m_star = x("m_star"),
            .dt = x("dt"),
            .extra_dashpot = x("extra_dashpot")};
}

Row mindlin() {
    const auto state = [](double friction, double radius) {
        Quantities in{{"g_star", pascal, 0.9e9},
                      {"sliding_friction", one, friction},
                      {"contact_radius", metre, radius},
                      {"previous_radius", metre, 1.3e-6},
                      {"cap_force", newton, 3e-4},
                      {"damping_factor", one, 0.4},
                      {"m_star", kilogram, 4.4e-9},
                      {"dt", second, 1e-7},
                      {"extra_dashpot", kilogram_per_second, 1.7e-3}};
        add(in, "spring", metre, {1.1e-8, 0.4e-8, -0.5e-8});
        add(in, "n", one, normal);
        add(in, "slip_velocity", metre_per_second, {0.010, -0.020, 0.0075});
        return State{in};
    };
    return {.law = "Mindlin",
            // sticks while it shrinks; slides while it grows
            .states = {state(2.0, 1.2e-6), state(0.05, 1.4e-6)},
            .evaluate = [](const State& x) {
                const contact::Mindlin law{x("g_star"), x("sliding_friction")};
                const contact::TangentialState r = law.step(tangential_input(x));
                Quantities out{{"stored", joule, r.stored}, {"dissipated", joule, r.dissipated}};
                add(out, "force", newton, r.force_on_j);
                add(out, "spring", metre, r.spring);
                return out;
            }};
}

Row coulomb() {
    const auto state = [](double friction) {
        Quantities in{{"sliding_friction", one, friction},
                      {"cap_force", newton, 3e-4},
                      {"m_star", kilogram, 4.4e-9},
                      {"dt", second, 1e-7}};
        add(in, "slip_velocity", metre_per_second, {0.010, -0.020, 0.0075});
        return State{in};
    };
    return {.law = "Coulomb",
            .states = {state(0.3), state(3.0)},  // slides; is stopped, by 3e-4 N
            .evaluate = [](const State& x) {
                const contact::Coulomb law{x("sliding_friction")};
                const contact::TangentialState r = law.step(tangential_input(x));
                Quantities out{{"dissipated", joule, r.dissipated}};
                add(out, "force", newton, r.force_on_j);
                return out;
            }};
}

contact::RollingInput rolling_input(const State& x) {
    return {.spring = x.vector("spring"),
            .n = x.vector("n"),
            .spin_i = x.vector("spin_i"),
            .spin_j = x.vector("spin_j"),
            .r_i = x("r_i"),
            .r_j = x("r_j"),
            .r_star = x("r_star"),
            .inverse_inertia_i = x("inverse_inertia_i"),
            .inverse_inertia_j = x("inverse_inertia_j"),
            .e_star = x("e_star"),
            .previous_radius = x("previous_radius"),
            .contact_radius = x("contact_radius"),
            .cap_force = x("cap_force"),
            .dt = x("dt")};
}

// What all rolling laws use.
Quantities common_rolling_inputs(double cap_force) {
    Quantities in{
        {"cap_force", newton, cap_force}, {"dt", second, 1e-7}, {"rolling_friction", one, 0.2}};
    add(in, "spin_i", per_second, {120.0, -35.0, 60.0});
    add(in, "spin_j", per_second, {-80.0, 15.0, 44.0});
    return in;
}

Quantities torques_and_loss(const contact::RollingState& r) {
    Quantities out{{"dissipated", joule, r.dissipated}};
    add(out, "torque_on_i", joule, r.torque_on_i);
    add(out, "torque_on_j", joule, r.torque_on_j);
    return out;
}

Row epsd() {
    const auto state = [](double cap_force) {
        Quantities in = common_rolling_inputs(cap_force);
        in.push_back({"r_star", metre, 6.3e-5});
        in.push_back({"inverse_inertia_i", per_inertia, 2.3e16});
        in.push_back({"inverse_inertia_j", per_inertia, 0.5e16});
        in.push_back({"e_star", pascal, 3.1e9});
        in.push_back({"contact_radius", metre, 1.3e-6});
        in.push_back({"previous_radius", metre, 1.1e-6});
        in.push_back({"damping_ratio", one, 0.3});
        add(in, "n", one, normal);
        add(in, "spring", one, {2e-5, -3e-5, 1e-5});
        return State{in};
    };
    return {.law = "RollingEpsd",
            .states = {state(3e-2), state(1e-6)},  // sticks; is fully mobilised
            .evaluate = [](const State& x) {
                const contact::RollingEpsd law{x("rolling_friction"), x("damping_ratio")};
                const contact::RollingState r = law.step(rolling_input(x));
                Quantities out = torques_and_loss(r);
                out.push_back({"stored", joule, r.stored});
                add(out, "spring", one, r.spring);
                return out;
            }};
}

Row sds() {
    const auto state = [](double cap_force) {
        Quantities in = common_rolling_inputs(cap_force);
        in.push_back({"r_star", metre, 6.3e-5});
        in.push_back({"stiffness", newton_per_metre, 900.0});
        in.push_back({"damping", kilogram_per_second, 5e-5});
        add(in, "n", one, normal);
        add(in, "spring", metre, {2e-9, -3e-9, 1e-9});
        return State{in};
    };
    return {.law = "RollingSds",
            .states = {state(3e-2), state(1e-6)},  // sticks; slides
            .evaluate = [](const State& x) {
                const contact::RollingSds law{x("stiffness"), x("damping"), x("rolling_friction")};
                const contact::RollingState r = law.step(rolling_input(x));
                Quantities out = torques_and_loss(r);
                out.push_back({"stored", joule, r.stored});
                add(out, "spring", metre, r.spring);
                return out;
            }};
}

Row edem_standard() {
    const auto state = [](double cap_force) {
        Quantities in = common_rolling_inputs(cap_force);
        in.push_back({"r_i", metre, 1.1e-4});
        in.push_back({"r_j", metre, 1.5e-4});
        in.push_back({"inverse_inertia_i", per_inertia, 2.3e16});
        in.push_back({"inverse_inertia_j", per_inertia, 0.5e16});
        return State{in};
    };
    return {.law = "RollingEdemStandard",
            .states = {state(3e-6), state(3e-1)},  // brakes; stops
            .evaluate = [](const State& x) {
                const contact::RollingEdemStandard law{x("rolling_friction")};
                return torques_and_loss(law.step(rolling_input(x)));
            }};
}

Row rvd() {
    const auto state = [](double cap_force) {
        Quantities in = common_rolling_inputs(cap_force);
        in.push_back({"r_star", metre, 6.3e-5});
        in.push_back({"inverse_inertia_i", per_inertia, 2.3e16});
        in.push_back({"inverse_inertia_j", per_inertia, 0.5e16});
        add(in, "n", one, normal);
        return State{in};
    };
    return {.law = "RollingRvd",
            .states = {state(3e-6), state(3e-1)},  // brakes; stops
            .evaluate = [](const State& x) {
                const contact::RollingRvd law{x("rolling_friction")};
                return torques_and_loss(law.step(rolling_input(x)));
            }};
}

Row twisting() {
    const auto state = [](double cap_force, double contact_radius) {
        return State{{{"g_star", pascal, 9e8},
                      {"sliding_friction", one, 0.6},
                      {"angle", one, 2e-3},
                      {"previous_radius", metre, 1.1e-6},
                      {"contact_radius", metre, contact_radius},
                      {"spin", per_second, 300.0},
                      {"cap_force", newton, cap_force},
                      {"damping_factor", one, 0.5},
                      {"m_star", kilogram, 2e-9},
                      {"dt", second, 1e-7},
                      {"extra_dashpot", kilogram_per_second, 1.2e-3}}};
    };
    return {
        .law = "TwistingMarshall2009",
        .states = {state(1.0, 1.2e-6), state(1e-6, 1.0e-6)},  // sticks as it grows; is mobilised
        .evaluate = [](const State& x) {
            const contact::TwistingMarshall2009 law{x("g_star"), x("sliding_friction")};
            const contact::TwistingState r = law.step({.angle = x("angle"),
                                                       .previous_radius = x("previous_radius"),
                                                       .contact_radius = x("contact_radius"),
                                                       .spin = x("spin"),
                                                       .cap_force = x("cap_force"),
                                                       .damping_factor = x("damping_factor"),
                                                       .m_star = x("m_star"),
                                                       .dt = x("dt"),
                                                       .extra_dashpot = x("extra_dashpot")});
            return Quantities{{"torque_on_j", joule, r.torque_on_j},
                              {"angle", one, r.angle},
                              {"stored", joule, r.stored},
                              {"dissipated", joule, r.dissipated}};
        }};
}

Row drag() {
    const auto state = [](double speed) {  // Re = 67 u s/m
        return State{{{"factor", one, 1.2},
                      {"density", kilogram_per_cubic_metre, 1.204},
                      {"viscosity", pascal_second, 1.81e-5},
                      {"diameter", metre, 1e-3},
                      {"speed", metre_per_second, speed}}};
    };
    return {.law = "DragSchiller1935", .states = {state(0.4)}, .evaluate = [](const State& x) {
                const contact::DragSchiller1935 law{x("factor"), x("density"), x("viscosity")};
                const auto r = law.at(x("diameter"), x("speed"));
                return Quantities{{"resistance", kilogram_per_second, r.value},
                                  {"growth", kilogram_per_second, r.growth}};
            }};
}

}  // namespace

std::vector<Row> all_laws() {
    return {hertz(),
            jkr(),
            damping(),
            viscoelastic(),
            friction_cap(),
            mindlin(),
            coulomb(),
            epsd(),
            sds(),
            edem_standard(),
            rvd(),
            twisting(),
            capillary_bridge(),
            ageing(),
            drag()};
}
