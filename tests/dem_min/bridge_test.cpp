// SPDX-License-Identifier: MIT
// Capillary bridges in the core: forces of a pair held by hand against the closed forms of contact/capillary_bridge.hpp's
// sources, the bridge's birth and end, and what a parting pair has paid.
#include "tests/dem_min/system.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using dem_min::Ledger;
using dem_min::Simulation;
using samples::dry;
using samples::Powder;
using samples::sticky;
using std::numbers::pi;

namespace {

constexpr double gamma_of_water = 0.072, volume = 2e-17, angle = 0.2;  // N/m, m^3, rad
constexpr double radius = 5e-5;                                        // m
const double rupture = 1.1 * std::cbrt(volume);                        // m, (1 + theta/2) V^(1/3)

// Two grains, or a grain over a plane, whose distance is set by hand: the force of each place, all velocities nought.
struct Held {
    Simulation s;
    double r_star, reach;  // m; of the centres, or of centre and plane, at touch

    Held(const Powder& powder, double ratio_of_radii) {
        const double other = ratio_of_radii * radius;
        s.settings.time_step = 1e-12;  // a grain moves by 1e-18 m in it
        s.settings.skin = 0.1 * radius;
        s.settings.lost_below = -1.0;
        s.between_grains = s.at_walls = samples::laws(powder);
        s.between_grains.bridge = s.at_walls.bridge =
            contact::CapillaryBridge::from(scaling::in_si<scaling::EnergyPerArea>(gamma_of_water),
                                           scaling::in_si<scaling::Volume>(volume), angle);
        if (ratio_of_radii > 0.0) {
            dem_min::insert(s, {{0.0, 0.0, 0.0}, {}, {}, other, 2500.0, true});
            r_star = radius * other / (radius + other), reach = radius + other;
        } else {
            s.walls = {dem_min::Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}};
            r_star = reach = radius;
        }
        dem_min::insert(s, {{0.0, 0.0, 2.0 * reach}, {}, {}, radius, 2500.0, false});
    }

    double force_at(double gap) {  // N, > 0 away from the other
        dem_min::Particles& p = s.grains;
        const std::size_t k = p.count() - 1;
        p.x[k] = p.y[k] = p.vx[k] = p.vy[k] = p.vz[k] = 0.0;
        p.z[k] = reach + gap;
        s.list_is_stale = true;
        dem_min::step(s);
        return p.fz[k];
    }
    std::size_t contacts() const { return pair_count(s) + wall_contact_count(s); }
};

double closed(double r_star) { return 4.0 * pi * gamma_of_water * r_star * std::cos(angle); }

double across(double r_star, double gap) {
    return closed(r_star) * (1.0 - gap / std::sqrt(gap * gap + volume / (pi * r_star)));
}

// J, the integral of `across` from 0, by Simpson's rule: 400 points leave 1e-9 of it.
double work(double r_star, double gap) {
    const int n = 400;
    double sum = 0.0;
    for (int k = 0; k <= n; ++k)
        sum += (k == 0 || k == n ? 1.0 : k % 2 == 1 ? 4.0 : 2.0) * across(r_star, gap * k / n);
    return sum * gap / (3.0 * n);
}

}  // namespace

// 1e-7: a grain of 1.3e-9 kg under 5e-5 N moves 4e-20 m in the step, 1e-14 of its place is 1e-18 m, over gaps of 1e-7 m and more.
TEST_CASE(
    "a bridge forms at contact, pulls across the gap, ruptures, and is gone until the next contact",
    "[dem_min][bridge][exact]") {
    const double ratio = GENERATE(1.0, 3.0, 0.0);  // of the radii; 0: a wall
    const Powder powder = GENERATE(dry(), sticky());
    Held pair(powder, ratio);
    CAPTURE(ratio, powder.work_of_adhesion);
    for (const double share : {1.5, 0.5, 0.01}) {  // on the way in there is no bridge
        REQUIRE(pair.force_at(share * rupture) == 0.0);
        REQUIRE(pair.contacts() == 0);
    }
    for (int again = 0; again < 2; ++again) {
        pair.force_at(-1e-8);
        REQUIRE(pair.contacts() == 1);
        for (const double share : {0.1, 0.3, 0.9, 0.999, 0.2}) {  // out, and back without touching
            const double gap = share * rupture;
            REQUIRE(pair.force_at(gap) == Approx(-across(pair.r_star, gap)).epsilon(1e-7));
            REQUIRE(pair.contacts() == 1);
        }
        REQUIRE(pair.force_at(1.001 * rupture) == 0.0);
        REQUIRE(pair.contacts() == 0);
        REQUIRE(pair.force_at(0.5 * rupture) == 0.0);
    }
}

// Over Hertz: at touch there is no elastic force. Over JKR: F = 4 E* a^3/(3 R*) - sqrt(8 pi w E* a^3) is deepest, 3/2 pi w R*, at
// a^3 = 9 pi w R*^2/(8 E*), where d = a^2/R* - sqrt(2 pi w a/E*) (docs/laws/jkr.md). Both pulls act side by side.
TEST_CASE("the pull-off force of a wet pair is that of the bridge and of the adhesion together",
          "[dem_min][bridge][exact]") {
    const double ratio = GENERATE(1.0, 3.0, 0.0);
    const bool adheres = GENERATE(false, true);
    const Powder p = adheres ? sticky() : dry();
    Held pair(p, ratio);
    const double w = p.work_of_adhesion, r_star = pair.r_star;
    const double a = std::cbrt(9.0 * pi * w * r_star * r_star / (8.0 * p.e_star));
    const double deepest = std::sqrt(2.0 * pi * w * a / p.e_star) - a * a / r_star;  // a gap
    pair.force_at(-1e-8);
    const double pull_off = closed(r_star) + 1.5 * pi * w * r_star;
    const double touch = adheres ? deepest : -1e-16;
    REQUIRE(pair.force_at(touch) == Approx(-pull_off).epsilon(1e-7));
    if (!adheres) return;
    REQUIRE(pair.force_at(0.98 * deepest) > -pull_off);
    REQUIRE(pair.force_at(1.02 * deepest) > -pull_off);
}

// A contact that was stretched beyond the fold of JKR, d = -1.60877 (w^2 R*/E*^2)^(1/3), is a bridge alone, and a new contact starts
// afresh, without the bond.
TEST_CASE("beyond the fold of the adhesion the bridge alone is left", "[dem_min][bridge][exact]") {
    const Powder p = sticky();
    Held pair(p, 1.0);
    const double fold = 1.60877 * std::cbrt(p.work_of_adhesion * p.work_of_adhesion * pair.r_star /
                                            (p.e_star * p.e_star));
    REQUIRE(1.1 * fold < rupture);
    pair.force_at(-1e-8);
    REQUIRE(pair.force_at(0.99 * fold) < -closed(pair.r_star));
    REQUIRE(pair.force_at(1.01 * fold) == Approx(-across(pair.r_star, 1.01 * fold)).epsilon(1e-7));
    REQUIRE(pair.force_at(0.5 * fold) == Approx(-across(pair.r_star, 0.5 * fold)).epsilon(1e-7));
}

namespace {

// Two grains that meet head on at `speed`, without dashpots; where they are after `duration`.
Simulation impact(Powder p, double speed, double duration, int refinement) {
    p.restitution = 1.0;
    samples::System system = samples::two_grains(p, speed, 1e-6, false);
    system.between_grains.bridge = contact::CapillaryBridge::from(
        scaling::in_si<scaling::EnergyPerArea>(1e-4 * gamma_of_water),
        scaling::in_si<scaling::Volume>(volume), angle);
    system.time_step /= refinement;
    Simulation s = samples::simulation(system, 1, true);
    advance(s, static_cast<std::int64_t>(duration / system.time_step));
    return s;
}

// J, what it takes to part the pair of `impact`: JKR's hysteresis (Thornton & Ning 1998), and the bridge stretched to its rupture:
// closed while the solids hold, out to the fold, then across the gap.
double price(const Powder& p) {
    const double r_star = 0.25 * p.diameter, w = p.work_of_adhesion;
    const double fold = 1.60877 * std::cbrt(w * w * r_star / (p.e_star * p.e_star));
    const double jkr =
        7.0922 * std::cbrt(std::pow(w, 5) * std::pow(r_star, 4) / (p.e_star * p.e_star));
    return jkr + 1e-4 * (closed(r_star) * fold + work(r_star, rupture) - work(r_star, fold));
}

}  // namespace

// 1e-4: digits of 7.0922 and 1.60877. Kinetic energy: 5 % at a quarter of the step, first order of birth and end.
TEST_CASE("a wet pair that parts has paid the work of its bridge and of its adhesion",
          "[dem_min][bridge][energy]") {
    const Powder p = GENERATE(dry(), sticky());
    const double m_star = 0.5 * p.density * pi / 6.0 * std::pow(p.diameter, 3);
    const double speed = 3.0 * std::sqrt(2.0 * price(p) / m_star);
    const Simulation s = impact(p, speed, 0.5 * p.diameter / speed, 4);
    REQUIRE(pair_count(s) == 0);
    const Ledger books = ledger(s);
    REQUIRE(books.heat.tear_off == Approx(price(p)).epsilon(1e-4));
    REQUIRE(books.heat.normal_dashpot == 0.0);
    REQUIRE(books.brought_in - books.kinetic == Approx(price(p)).epsilon(0.05));
}

// A tenth slower than the price of parting: it swings in the bridge for as long as one looks.
TEST_CASE("a wet pair too slow for its bridge stays together", "[dem_min][bridge][energy]") {
    const Powder p = GENERATE(dry(), sticky());
    const double m_star = 0.5 * p.density * pi / 6.0 * std::pow(p.diameter, 3);
    const double parts = std::sqrt(2.0 * price(p) / m_star);
    const Simulation held = impact(p, 0.9 * parts, 6.0 * p.diameter / parts, 4);
    REQUIRE(pair_count(held) == 1);
    REQUIRE(pair_count(impact(p, 1.1 * parts, 6.0 * p.diameter / parts, 4)) == 0);
}
