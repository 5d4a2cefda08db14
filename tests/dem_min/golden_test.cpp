// SPDX-License-Identifier: MIT
// The same bits from every path: with and without neighbour list, with any number of threads, today
// and tomorrow.
#include "dem_min/random.hpp"
#include "tests/dem_min/system.hpp"

#include <catch2/catch.hpp>

#include <cstdint>
#include <fstream>
#include <map>
#include <string>

using dem_min::reference_step;
using dem_min::Simulation;
using dem_min::state_hash;
using dem_min::step;
using samples::dry;
using samples::rain;
using samples::sticky;
using samples::System;

namespace {

struct Named {
    std::string name;
    System system;
};

Named glued_jkr() { return {"glued_jkr", rain(sticky(), 100, false, false)}; }
Named glued_jkr_sizes() { return {"glued_jkr_sizes", rain(sticky(), 100, false, true)}; }
Named walled_hertz() { return {"walled_hertz", rain(dry(), 100, true, false)}; }
Named walled_jkr_sizes() { return {"walled_jkr_sizes", rain(sticky(), 100, true, true)}; }

// Other laws of rolling and sliding, on which the same promises hold.
Named glued_other_laws() {
    System s = rain(sticky(), 60, false, true);
    s.between_grains.tangential = contact::Coulomb{0.4};
    s.between_grains.rolling = contact::RollingRvd{0.1};
    s.between_grains.friction_cap = contact::FrictionCap::total_plus_two_pull_off;
    return {"glued_other_laws", s};
}

// Bridges, over JKR and over Hertz; the second also ages what adheres at its walls. Not recorded: a library's logarithm.
Named glued_wet() {
    System s = rain(sticky(), 100, false, true);
    s.between_grains.bridge = samples::bridge(dry(), 8.0);
    return {"glued_wet", s};
}
Named walled_wet_ageing() {
    System s = rain(dry(), 100, true, true);
    s.at_walls = samples::laws(sticky());
    s.at_walls.ageing = {.rate = 2.0, .onset = 20.0 * s.time_step};
    s.between_grains.bridge = s.at_walls.bridge = samples::bridge(dry(), 8.0);
    return {"walled_wet_ageing", s};
}

std::map<std::string, std::uint64_t> recorded() {
    std::ifstream file("tests/dem_min/golden.txt");
    std::map<std::string, std::uint64_t> result;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        const std::size_t space = line.find(' ');
        result[line.substr(0, space)] = std::stoull(line.substr(space + 1));
    }
    return result;
}

}  // namespace

TEST_CASE("two grains: the step with lists gives the bits of the step without",
          "[dem_min][golden]") {
    const bool oblique = GENERATE(false, true);
    const System system = samples::two_grains(sticky(), 0.05, 5e-6, oblique);
    Simulation fast = samples::simulation(system), slow = fast;
    for (int k = 0; k < 1000; ++k) {
        step(fast);
        reference_step(slow);
        REQUIRE(state_hash(fast) == state_hash(slow));
    }
    REQUIRE(fast.steps == 1000);
}

TEST_CASE("a rain of grains: the step with lists gives the bits of the step without",
          "[dem_min][golden]") {
    const Named sample =
        GENERATE(glued_jkr(), glued_jkr_sizes(), walled_hertz(), walled_jkr_sizes(),
                 glued_other_laws(), glued_wet(), walled_wet_ageing());
    CAPTURE(sample.name);
    Simulation fast = samples::simulation(sample.system), slow = fast;
    std::size_t most_contacts = 0;
    for (int k = 0; k < 3000; ++k) {
        step(fast);
        reference_step(slow);
        most_contacts = std::max(most_contacts, pair_count(fast));
        if (k % 100 == 99) REQUIRE(state_hash(fast) == state_hash(slow));
    }
    REQUIRE(most_contacts > 10);  // or nothing was compared
}

// 2400 grains in a periodic box of 14 diameters, in random order, in random motion: three tiles
// whose contacts cross all borders, and a change of order (at step 4096). Sticky ones stay
// together, dry ones part again, and the slots of those that stay then move; so do wet ones whose little liquid holds few.
TEST_CASE("a dense cloud in several tiles: list, outboxes and threads change no bit",
          "[dem_min][golden]") {
    const double d = 1e-4, box = 14.0 * d;
    Simulation cloud;
    const bool wet = GENERATE(false, true), stay = !wet && GENERATE(true, false);
    const System like = rain(stay ? sticky() : dry(), 1, true, false);
    cloud.settings.time_step = like.time_step;
    cloud.settings.skin = 0.1 * d;
    cloud.settings.lost_below = -1.0;
    cloud.settings.period_x = cloud.settings.period_y = box;
    cloud.between_grains = cloud.at_walls = like.between_grains;
    if (wet) cloud.between_grains.bridge = samples::bridge(dry(), 1.0);
    cloud.walls = {dem_min::Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}},
                   dem_min::Plane{{0.0, 0.0, 14.0 * d}, {0.0, 0.0, -1.0}}};
    const dem_min::RandomStream numbers{5, 0};
    for (std::uint64_t k = 0; k < 2400; ++k) {
        const std::uint64_t site = (k * 1013) % 2744;  // 14^3 sites, 1013 is prime
        const auto place = [&](std::uint64_t cell, std::uint64_t axis) {
            return (static_cast<double>(cell) + 0.5 + 0.02 * numbers.uniform(8 * k + axis)) * d;
        };
        const auto speed = [&](std::uint64_t axis) {
            return 0.1 * numbers.uniform(8 * k + axis) - 0.05;
        };
        insert(cloud, {{place(site % 14, 0), place(site / 14 % 14, 1), place(site / 196, 2)},
                       {speed(3), speed(4), speed(5)},
                       {},
                       0.49 * d,
                       2500.0});
    }
    cloud.steps = 4000;  // 4096 is a multiple of reorder_interval
    Simulation slow = cloud, two = cloud, at_once = cloud;
    two.settings.threads = 3;
    two.settings.grains_per_thread = 1;
    std::size_t most_contacts = 0;
    for (int k = 0; k < 150; ++k) {
        step(cloud), step(two), reference_step(slow);
        most_contacts = std::max(most_contacts, pair_count(cloud));
    }
    advance(at_once, 150);
    REQUIRE(cloud.tiles.size() == 3);
    REQUIRE(most_contacts > (stay ? 1000u : 100u));
    REQUIRE((pair_count(cloud) < most_contacts) == !stay);  // contacts have ended
    REQUIRE(cloud.steps == 4150);
    int crossing = 0, turned_round = 0;
    for_each_contact(cloud, [&](std::size_t group, const dem_min::Contacts& c, std::size_t slot) {
        if (cloud.at_wall(group)) return;
        crossing += dem_min::tile_of(c.i[slot]) != dem_min::tile_of(c.j[slot]);
        turned_round += c.i[slot] > c.j[slot];
    });
    REQUIRE(crossing > 20);
    REQUIRE(turned_round > 20);
    REQUIRE(state_hash(cloud) == state_hash(slow));
    REQUIRE(state_hash(cloud) == state_hash(two));
    REQUIRE(state_hash(cloud) == state_hash(at_once));
}

TEST_CASE("a rain of grains: one, two, three and four threads give the same bits",
          "[dem_min][golden]") {
    const Named sample =
        GENERATE(glued_jkr(), glued_jkr_sizes(), walled_hertz(), glued_wet(), walled_wet_ageing());
    CAPTURE(sample.name);
    Simulation landing = samples::simulation(sample.system);
    for (int k = 0; k < 2000; ++k) step(landing);
    REQUIRE(pair_count(landing) + wall_contact_count(landing) > 10);
    const auto hash = [&](int threads) {
        Simulation s = landing;
        s.settings.threads = threads;
        s.settings.grains_per_thread = 1;
        for (int k = 0; k < 40; ++k) step(s);
        return state_hash(s);
    };
    const std::uint64_t alone = hash(1);
    for (const int threads : {2, 3, 4}) REQUIRE(hash(threads) == alone);
}

// The ledger reads the motion and must not touch it.
TEST_CASE("a rain of grains: keeping the ledger changes no bit", "[dem_min][golden]") {
    const System system =
        GENERATE(glued_jkr_sizes().system, glued_wet().system, walled_wet_ageing().system);
    Simulation with = samples::simulation(system, 1, true), without = samples::simulation(system);
    for (int k = 0; k < 1500; ++k) step(with), step(without);
    REQUIRE(state_hash(with) == state_hash(without));
}

TEST_CASE("a rain of grains: the bits are those recorded in golden.txt", "[dem_min][golden]") {
    const Named sample = GENERATE(glued_jkr(), glued_jkr_sizes(), walled_hertz(),
                                  walled_jkr_sizes(), glued_other_laws(), glued_wet());
    Simulation s = samples::simulation(sample.system);
    for (int k = 0; k < 3000; ++k) step(s);
    const auto hashes = recorded();
    CAPTURE(sample.name, std::to_string(state_hash(s)));
    REQUIRE(hashes.count(sample.name) == 1);
    REQUIRE(state_hash(s) == hashes.at(sample.name));
}
