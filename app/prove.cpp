// SPDX-License-Identifier: MIT
#include "app/prove.hpp"

#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/progress.hpp"
#include "prove/campaign.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>

namespace app {
namespace {

struct ProveOptions {
    CommonOptions common;
    prove::Extent extent;
    std::string out = "out/prove", kind, rig;
    bool write_only = false;
};

constexpr const char* examples = R"(Examples:
  similitude prove --cases 60 --seed 7 --write-only --out out/blind
      60 cases of every kind in out/blind/cases, their keys in out/blind/keys
  similitude prove --cases 20 --seed 7 --kind single --rig drop --write-only --out out/drops
      the first 20 of that seed that conceal one effect from a falling grain)";

int run(ProveOptions o) {
    o.extent.seed = o.common.seed;
    if (!o.kind.empty()) o.extent.kind = prove::kind_of(o.kind);
    o.extent.rig = o.rig;
    watch_interrupts();
    Progress progress(!o.common.quiet);
    const std::filesystem::path out = o.out;
    const std::vector<int> numbers = prove::numbers_of(o.extent);
    double done = 0.0;
    for (const int number : numbers) {
        if (interrupt_flag()) return interrupted;
        if (!o.common.resume || !prove::is_written(number, out / "cases", out / "keys"))
            prove::write(prove::make_case(o.extent.seed, number), out / "cases", out / "keys");
        done += 1.0;
        progress.show(done, static_cast<double>(numbers.size()), prove::case_name(number));
    }
    return fine;
}

}  // namespace

Verb prove_verb(CLI::App& app, const std::string&) {
    const auto options = std::make_shared<ProveOptions>();
    CLI::App* verb = app.add_subcommand("prove", "blind cases with concealed effects");
    verb->add_option("--cases", options->extent.cases, "how many")->capture_default_str();
    verb->add_option("--kind", options->kind,
                     "only null, single, look_alike, pair, outside or numerical");
    verb->add_option("--rig", options->rig, "only this rig");
    verb->add_option("--shard", options->extent.shard,
                     "i/n: every n-th case, beginning with the i-th")
        ->capture_default_str();
    verb->add_option("--out", options->out, "folder")->type_name("DIR")->capture_default_str();
    verb->add_flag("--write-only", options->write_only, "write the cases, judge none")->required();
    add_common(*verb, options->common);
    verb->footer(examples);
    return {verb, [options] { return run(*options); }};
}

}  // namespace app
