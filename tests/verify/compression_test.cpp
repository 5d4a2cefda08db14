// SPDX-License-Identifier: MIT
// The compression study: what its rules do to a setup, how its campaign is remembered, what it makes of its samples.
#include "verify/compression_study.hpp"

#include <catch2/catch.hpp>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <string>
#include <unistd.h>

using verify::CompressionPlan;
using verify::CompressionSample;

namespace {

struct Scratch {
    std::filesystem::path path = std::filesystem::temp_directory_path() /
                                 ("similitude-compression-" + std::to_string(getpid()));
    ~Scratch() { std::filesystem::remove_all(path); }
};

// 190 grains in a fast press: a second for all of it.
const CompressionPlan tiny{.width = 5.0, .height = 15.0, .h = {1.5}, .seeds = 2, .speed = 1.0};

verify::CompressionJob job(const std::string& name, std::uint64_t seed) {
    return {.name = name,
            .seed = seed,
            .setup = compression_setup(tiny, verify::adhesion_rules().front(), 1.5, seed)};
}

verify::Campaign campaign_on(int threads) {
    verify::Campaign campaign;
    campaign.threads = threads;
    return campaign;
}

double pull_off_force(const rigs::CompressionSetup& s) {  // between two nominal grains
    return 1.5 * 3.14159265358979 * s.grains.work_of_adhesion * 0.25 * s.d;
}

}  // namespace

TEST_CASE("adhesion rules: the pull-off force goes as d^2, d, d^3 and stays nothing",
          "[verify][compression][exact]") {
    const double h = GENERATE(1.25, 2.0);
    const double powers[] = {2.0, 1.0, 3.0};
    for (std::size_t k = 0; k < 4; ++k) {
        const verify::AdhesionRule& rule = verify::adhesion_rules().at(k);
        CAPTURE(rule.name, h);
        const auto one = compression_setup(tiny, rule, 1.0, 1),
                   large = compression_setup(tiny, rule, h, 1);
        if (k < 3)
            CHECK(pull_off_force(large) / pull_off_force(one) ==
                  Approx(std::pow(h, powers[k])).epsilon(1e-12));
        else
            CHECK(pull_off_force(large) == 0.0);
        CHECK(large.grains.e_star == one.grains.e_star);
        CHECK(large.cell.solid_volume == one.cell.solid_volume);
        CHECK(large.cell.stress == one.cell.stress);
        CHECK(large.cell.speed == one.cell.speed);
        // h^3 fewer grains; they are whole.
        CHECK(static_cast<double>(large.radius.size()) * h * h * h ==
              Approx(static_cast<double>(one.radius.size())).margin(0.51 * (h * h * h + 1.0)));
    }
}

TEST_CASE("compressions: what was finished before a signal is remembered, and by its setup",
          "[verify][compression]") {
    const Scratch folder;
    const std::vector<verify::CompressionJob> jobs = {job("a", 1), job("b", 2)};
    const std::vector<CompressionSample> unbroken = run_compressions(jobs, campaign_on(2));
    std::atomic<bool> stop = false;
    verify::Campaign campaign = campaign_on(1);
    campaign.remembered_in = folder.path, campaign.stop = &stop;
    campaign.progress = [&](double, double, const std::string& ended) { stop = !ended.empty(); };
    REQUIRE_THROWS_AS(run_compressions(jobs, campaign), verify::Interrupted);
    REQUIRE(std::filesystem::exists(file_of(jobs[0], folder.path)));
    REQUIRE_FALSE(std::filesystem::exists(file_of(jobs[1], folder.path)));
    stop = false;
    int ended = 0;
    campaign.progress = [&](double, double, const std::string& name) { ended += !name.empty(); };
    const std::vector<CompressionSample> resumed = run_compressions(jobs, campaign);
    CHECK(ended == 1);  // the other one was remembered
    for (std::size_t k = 0; k < jobs.size(); ++k) {
        CHECK(resumed[k].hash == unbroken[k].hash);
        CHECK(resumed[k].strength == unbroken[k].strength);
        CHECK(resumed[k].packing_fraction == unbroken[k].packing_fraction);
        CHECK(resumed[k].confined.stress == unbroken[k].confined.stress);
        CHECK(resumed[k].crushed.strain == unbroken[k].crushed.strain);
        CHECK(resumed[k].inertial_number_of_crush == unbroken[k].inertial_number_of_crush);
    }
    CHECK(resumed[0].hash != resumed[1].hash);
    verify::CompressionJob other = jobs[0];
    other.setup.grains.work_of_adhesion *= 2.0;
    CHECK(file_of(other, folder.path) != file_of(jobs[0], folder.path));
}

TEST_CASE("compression study: bits under exact scaling, every rule, no seed twice",
          "[verify][compression]") {
    const verify::CompressionStudy study = compression_study(tiny, 7, campaign_on(2));
    CHECK(study.bits.equal);
    CHECK(study.bits.grains > 40);
    REQUIRE(study.rules.size() == 4);
    std::vector<std::uint64_t> seeds;
    for (const verify::RuleResult& r : study.rules) {
        REQUIRE(r.cells.size() == 1);
        CHECK(r.cells[0].quantities.size() == (r.rule.adhesive ? 4 : 3));
        for (const CompressionSample& s : r.cells[0].side.samples) seeds.push_back(s.seed);
        if (!r.rule.adhesive) continue;
        // With two sizes of grain least squares go through the means: the slope by hand.
        const auto mean_of = [](const verify::CompressionSide& side) {
            return 0.5 * (std::log(side.samples[0].strength) + std::log(side.samples[1].strength));
        };
        const double p = (mean_of(r.cells[0].side) - mean_of(r.reference)) / std::log(1.5);
        CHECK(r.strength_exponent == Approx(p).epsilon(1e-9));
        CHECK(r.strength_exponent_interval.low < p);
        CHECK(r.strength_exponent_interval.high > p);
    }
    for (const verify::RuleResult* r : {&study.rules.front(), &study.rules.back()})
        for (const CompressionSample& s : r->reference.samples) seeds.push_back(s.seed);
    for (const CompressionSample& s : study.half_speed.side.samples) {
        seeds.push_back(s.seed);
        CHECK(s.inertial_number < study.largest_inertial_number);
    }
    std::sort(seeds.begin(), seeds.end());
    CHECK(std::adjacent_find(seeds.begin(), seeds.end()) == seeds.end());
    CHECK(seeds.size() == 14);
    // 20 steps between looks at a fast piston.
    CHECK(study.rules[0].reference.samples[0].confined.stress.back() ==
          Approx(study.powder.stress).epsilon(0.25));
}

TEST_CASE(
    "compression study among larger grains: the same samples, each rule against its smallest h",
    "[verify][compression]") {
    CompressionPlan plan = tiny;
    plan.h = {1.25, 1.5};
    const verify::CompressionStudy whole = compression_study(plan, 7, campaign_on(2));
    plan.among_larger = true;
    const verify::CompressionStudy study = compression_study(plan, 7, campaign_on(2));
    for (std::size_t k = 0; k < 4; ++k) {
        const verify::RuleResult& r = study.rules[k];
        CAPTURE(r.rule.name);
        REQUIRE(r.cells.size() == 1);
        CHECK(r.reference.h == 1.25);
        CHECK(r.cells[0].side.h == 1.5);
        for (std::size_t s = 0; s < 2; ++s) {
            CHECK(r.reference.samples[s].hash == whole.rules[k].cells[0].side.samples[s].hash);
            CHECK(r.cells[0].side.samples[s].hash == whole.rules[k].cells[1].side.samples[s].hash);
        }
    }
    CHECK(study.half_speed.side.samples[0].hash == whole.half_speed.side.samples[0].hash);
}
