// SPDX-License-Identifier: MIT
#include "verify/against_lammps.hpp"

#include "engines/lammps_run.hpp"
#include "engines/process.hpp"
#include "verify/pile_runs.hpp"

#include <chrono>

namespace verify {
namespace {

void add(std::vector<Check>& to, const std::vector<Check>& checks) {
    to.insert(to.end(), checks.begin(), checks.end());
}

}  // namespace

AgainstLammps against_lammps(const LammpsCampaign& campaign) {
    const auto start = std::chrono::steady_clock::now();
    const std::filesystem::path lmp = engines::lammps_program();
    const auto tell = [&](double done, const char* what) {
        if (campaign.stop != nullptr && campaign.stop->load()) throw Interrupted{};
        if (campaign.progress) campaign.progress(done, 3.0, what);
    };
    AgainstLammps result;
    result.release = engines::lammps_release(
        engines::run({lmp.string(), "-log", "none"}, std::filesystem::temp_directory_path(), 60.0)
            .out);
    tell(0.0, "two grains, led");
    result.checks = led_checks(lmp, campaign.folder);
    tell(1.0, "two grains, thrown");
    add(result.checks, thrown_checks(lmp, campaign.folder));
    tell(2.0, "where the rules differ");
    result.differences = rule_differences(lmp, campaign.folder);
    if (campaign.heaps > 0) {
        result.heaps = heap_round(lmp, campaign);
        add(result.checks, heap_checks(*result.heaps));
    }
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace verify
