// SPDX-License-Identifier: MIT
#include "app/verify_against.hpp"

#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/progress.hpp"
#include "reports/against.hpp"
#include "verify/pile_runs.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <optional>

namespace app {

namespace {

constexpr int heaps_a_side = 14;  // their angles scatter by 1 to 2 deg: 12 a side give 95 % power

// Nothing where a signal came; it also ends LAMMPS, which then looks like a failure of its own.
std::optional<verify::AgainstLammps> compared(const CommonOptions& o, const std::string& out,
                                              bool with_heaps) {
    Progress progress(!o.quiet);
    verify::LammpsCampaign campaign;
    campaign.folder = std::filesystem::absolute(std::filesystem::path(out) / "similitude-lammps");
    campaign.heaps = with_heaps ? heaps_a_side : 0;
    campaign.first_seed = o.seed;
    campaign.threads = threads_of(o);
    campaign.resume = o.resume;
    campaign.stop = &interrupt_flag();
    campaign.progress = [&progress](double done, double of, const std::string& what) {
        progress.show(done, of, what);
    };
    try {
        return verify::against_lammps(campaign);
    } catch (const verify::Interrupted&) {
        return {};
    } catch (const std::exception&) {
        if (interrupt_flag().load()) return {};
        throw;
    }
}

}  // namespace

int verify_against(const CommonOptions& o, const std::string& out, bool with_heaps,
                   const std::string& command) {
    watch_interrupts();
    const auto result = compared(o, out, with_heaps);
    if (!result) {
        fmt::print(stderr, "similitude: interrupted; the same command with --resume goes on\n");
        return interrupted;
    }
    reports::Provenance who = provenance(command, "");
    if (result->heaps)
        for (const verify::HeapAngle& h : result->heaps->heaps) who.seeds.push_back(h.seed);
    reports::Json json = {{"format", "similitude-verification/1"}, {"tool", reports::to_json(who)}};
    json.update(reports::to_json(*result));
    print(o, reports::text_of(*result));
    write_results(o, json, [&] { return reports::page_of(*result, who); });
    return reports::verdict_of(*result).answer == reports::Answer::yes ? fine : answer_is_no;
}

}  // namespace app
