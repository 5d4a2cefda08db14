// SPDX-License-Identifier: MIT
#include "verify/sleep_study.hpp"

#include <fmt/format.h>

#include <chrono>

namespace verify {
namespace {

PileJob job(const cases::Case& c, const cases::Experiment& e, bool may_sleep, std::uint64_t seed) {
    PileJob job{.name = fmt::format("{}-{}-{}", e.id, may_sleep ? "may-sleep" : "awake", seed),
                .seed = seed,
                .setup = rigs::pile_setup(c, e, seed)};
    if (may_sleep) job.setup.sleep_speed = rigs::speed_of_rest(job.setup);
    return job;
}

Saved saved_by(const std::vector<PileSample>& samples) {
    Saved mean{};
    for (const PileSample& s : samples) {
        mean.whole += s.slept / static_cast<double>(samples.size());
        mean.while_fed += s.slept_while_fed / static_cast<double>(samples.size());
    }
    return mean;
}

}  // namespace

SleepStudy sleep_study(const cases::Case& c, const cases::Experiment& e, int seeds,
                       std::uint64_t first_seed, const Campaign& campaign) {
    const auto start = std::chrono::steady_clock::now();
    const auto side_jobs = [&](bool may_sleep, std::uint64_t first) {
        return jobs(seeds, first, [&](std::uint64_t seed) { return job(c, e, may_sleep, seed); });
    };
    Plan plan;
    const std::size_t awake = plan.add(side_jobs(false, first_seed));
    const std::size_t asleep = plan.add(side_jobs(true, first_seed + 1000));
    plan.run(campaign);

    const auto side = [&](const std::string& label, std::size_t group) {
        Side result = side_of(label, plan.job(group), e.grain.poisson_ratio.value.value());
        result.samples = plan.samples(group);
        return result;
    };
    const Margins margins;
    SleepStudy study{
        .experiment = e.id,
        .grains = plan.job(awake).setup.conditions.grains,
        .margins = margins,
        .comparison = compare("sleep, " + e.id, "whether quiet regions are left out",
                              side("awake", awake), side("may sleep", asleep), margins),
        .saved = {}};
    study.saved = saved_by(study.comparison.scaled.samples);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    study.seconds = seconds.count();
    return study;
}

}  // namespace verify
