// SPDX-License-Identifier: MIT
// Heaps of a campaign that another engine runs.
#include "cases/read_case.hpp"
#include "engines/lammps_piles.hpp"
#include "engines/process.hpp"
#include "scaling/errors.hpp"
#include "verify/similarity.hpp"

#include <catch2/catch.hpp>

#include <atomic>
#include <filesystem>
#include <string>
#include <unistd.h>
#include <vector>

using Catch::Matchers::Contains;

namespace {

struct Scratch {
    std::filesystem::path path = std::filesystem::temp_directory_path() /
                                 ("similitude-pile-engine-" + std::to_string(getpid()));
    ~Scratch() { std::filesystem::remove_all(path); }
};

constexpr verify::ReferenceHeap small{
    .base = 6.0, .drop_height = 5.0, .feed_diameter = 4.0, .grains = 12, .lammps_rules = true};

verify::PileJob job(const std::string& name, std::uint64_t seed, double h = 1.0) {
    const cases::Case c = cases::read_case("data/zirconia/case.json");
    const auto map = scaling::ScaleMap::solve(scaling::named_scheme("kept_gravity"), h);
    return {.name = name,
            .seed = seed,
            .setup = rigs::scaled(verify::reference_setup(c, small, seed), map),
            .unit_of_length = map.factor("length"),
            .unit_of_time = map.factor("time")};
}

// Our own core behind the interface: runs at most so many, then a signal comes.
struct Counted : rigs::PileEngine {
    std::string called;
    std::atomic<bool>* stop;
    int may, runs = 0;
    Counted(std::string name, std::atomic<bool>* flag, int most)
        : called(std::move(name)), stop(flag), may(most) {}
    std::string name() const override { return called; }
    std::string key(const rigs::PileSetup&) const override { return called; }
    std::optional<rigs::PileEnd> run(const rigs::PileSetup& s,
                                     const std::function<void(std::int64_t)>& show) override {
        if (runs == may) {
            *stop = true;
            return {};
        }
        ++runs;
        rigs::PileRun r = rigs::begin_pile(s, 1);
        while (!r.finished) rigs::advance(r, s, 1000);
        show(r.simulation.steps);
        rigs::PileRecord record = rigs::record(r, s);
        return rigs::PileEnd{std::move(r), std::move(record)};
    }
};

}  // namespace

TEST_CASE("pile engine: what it has finished before a signal is remembered, and as its own",
          "[verify][engine]") {
    const Scratch folder;
    std::atomic<bool> stop = false;
    const std::vector<verify::PileJob> jobs = {job("a", 1), job("b", 2)};
    verify::Campaign campaign;
    campaign.threads = 2, campaign.remembered_in = folder.path, campaign.stop = &stop;
    Counted first("one", &stop, 1);
    campaign.engine = &first;
    CHECK_THROWS_AS(verify::run_piles(jobs, campaign), verify::Interrupted);
    CHECK(first.runs == 1);

    stop = false;
    Counted same("one", &stop, 9), other("other", &stop, 9);
    campaign.engine = &same;
    const auto samples = verify::run_piles(jobs, campaign);
    CHECK(same.runs == 1);  // the heap that was cut off
    campaign.engine = &other;
    verify::run_piles(jobs, campaign);
    CHECK(other.runs == 2);
    campaign.engine = nullptr;
    const auto here = verify::run_piles(jobs, campaign);
    CHECK(here[0].hash == samples[0].hash);
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path), {}) == 6);
}

TEST_CASE("pile engine: what friction multiplies is part of what is remembered",
          "[verify][engine]") {
    verify::PileJob a = job("a", 1), b = a;
    b.setup.grains.friction_cap = contact::FrictionCap::repulsive_part;
    CHECK(verify::file_of(a, "x") != verify::file_of(b, "x"));
}

TEST_CASE("pile engine: SDS rolling is part of what is remembered", "[verify][engine]") {
    verify::PileJob a = job("a", 1), b = a;
    b.setup.grains.as_lammps->rolling_damping *= 2.0;
    CHECK(verify::file_of(a, "x") != verify::file_of(b, "x"));
    b = a, b.setup.grains.as_lammps.reset();
    CHECK(verify::file_of(a, "x") != verify::file_of(b, "x"));
}

// 256 times the length, 16 times the time. A heap of 1441 grains is not the same any more (docs/verify.md).
TEST_CASE(
    "pile engine: a dozen grains of LAMMPS are the same to the last bit after rescaling by 256",
    "[verify][engine][lammps]") {
    if (!engines::find_program("lmp")) return;
    const Scratch folder;
    engines::LammpsPiles lammps(folder.path / "deck", 1);
    verify::Campaign campaign;
    campaign.remembered_in = folder.path / "heaps", campaign.engine = &lammps;
    double last = 0.0;
    campaign.progress = [&](double done, double of, const std::string&) { last = done / of; };
    const auto s = verify::run_piles({job("reference", 1), job("scaled", 1, 256.0)}, campaign);
    CHECK(last == 1.0);
    CHECK(s[0].at_rest);
    CHECK(s[0].grains_on_base > 3.0);
    CHECK(s[0].grains_on_base + s[0].grains_lost == 12.0);
    CHECK(s[0].hash == s[1].hash);
    CHECK_FALSE(std::filesystem::exists(folder.path / "deck"));
}

TEST_CASE("pile engine: what LAMMPS has not is refused before anything runs",
          "[verify][engine][lammps]") {
    if (!engines::find_program("lmp")) return;
    const Scratch folder;
    engines::LammpsPiles lammps(folder.path / "deck", 1);
    verify::Campaign campaign;
    campaign.engine = &lammps;
    verify::PileJob good = job("good", 1), bad = job("bad", 2);
    bad.setup.conditions.base = rigs::Base::flat_with_rim;
    CHECK_THROWS_WITH(verify::run_piles({good, bad}, campaign), Contains("glued_grains"));
    CHECK_FALSE(std::filesystem::exists(folder.path / "deck"));
}
