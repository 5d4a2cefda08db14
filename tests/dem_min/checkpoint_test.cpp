// SPDX-License-Identifier: MIT
#include "dem_min/checkpoint.hpp"

#include "scaling/errors.hpp"
#include "tests/dem_min/system.hpp"
#include "tests/dem_min/temporary_file.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <string>

using dem_min::Simulation;
using dem_min::step;

namespace {

// A file of its own for each process that runs a test, taken away afterwards.
void run(Simulation& s, int steps) {
    for (int k = 0; k < steps; ++k) step(s);
}

}  // namespace

TEST_CASE("a run that goes on from a checkpoint gives the bits of one never interrupted",
          "[dem_min][checkpoint]") {
    const bool walled = GENERATE(false, true), wet_and_ageing = GENERATE(false, true);
    samples::System system = samples::rain(samples::sticky(), 60, walled, true);
    if (wet_and_ageing) {
        system.between_grains.bridge = system.at_walls.bridge =
            samples::bridge(samples::dry(), 8.0);
        system.between_grains.ageing = {.rate = 2.0, .onset = 20.0 * system.time_step};
    }
    Simulation whole = samples::simulation(system, 1, true);
    run(whole, 1700);
    REQUIRE(pair_count(whole) + wall_contact_count(whole) > 10);  // history to be kept
    const samples::TemporaryFile file;
    dem_min::write_checkpoint(whole, file.path);
    Simulation resumed = samples::simulation(system, 1, true);
    dem_min::read_checkpoint(resumed, file.path);
    REQUIRE(state_hash(resumed) == state_hash(whole));
    run(whole, 1500), run(resumed, 1500);
    REQUIRE(resumed.steps == whole.steps);
    REQUIRE(state_hash(resumed) == state_hash(whole));
    REQUIRE(ledger(resumed).heat.total() == ledger(whole).heat.total());
}

TEST_CASE("a checkpoint that is not whole is refused and changes nothing",
          "[dem_min][checkpoint]") {
    Simulation s = samples::simulation(samples::rain(samples::sticky(), 20, false, false));
    run(s, 300);
    const samples::TemporaryFile file;
    dem_min::write_checkpoint(s, file.path);
    const std::uintmax_t size = std::filesystem::file_size(file.path);
    const std::uint64_t before = state_hash(s);
    // Half of it; all but the last byte; nothing; a wrong mark at the beginning.
    const int damage = GENERATE(0, 1, 2, 3);
    if (damage < 3)
        std::filesystem::resize_file(file.path, damage == 0   ? size / 2
                                                : damage == 1 ? size - 1
                                                              : 0);
    else
        std::fstream(file.path, std::ios::binary | std::ios::in | std::ios::out).put('x');
    run(s, 10);
    const std::uint64_t later = state_hash(s);
    REQUIRE(later != before);
    REQUIRE_THROWS_AS(dem_min::read_checkpoint(s, file.path), scaling::InvalidInput);
    REQUIRE(state_hash(s) == later);
}

TEST_CASE("a checkpoint that is not there is refused by its name", "[dem_min][checkpoint]") {
    Simulation s;
    REQUIRE_THROWS_WITH(dem_min::read_checkpoint(s, "no/such/file"),
                        Catch::Contains("no/such/file"));
}
