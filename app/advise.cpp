// SPDX-License-Identifier: MIT
#include "app/advise.hpp"

#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/machine_speed.hpp"
#include "app/progress.hpp"
#include "app/remembered_campaign.hpp"
#include "app/scale_input.hpp"
#include "app/scaled_case.hpp"
#include "cases/messages.hpp"
#include "cases/read_case.hpp"
#include "cases/units.hpp"
#include "reports/advice.hpp"
#include "reports/scaling_map_json.hpp"
#include "scaling/errors.hpp"
#include "statistics/equivalence.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>

namespace app {

namespace {

namespace fs = std::filesystem;
using scaling::InvalidInput;
using scaling::mistake;
using verify::AdvisedGrain;

struct AdviseOptions {
    CommonOptions common;
    std::string path, budget, tolerance, experiment, map = "data/scaling-map/small.json",
                                                     out = "out/advice";
    int seeds = 0;  // a side; 0: as many as the map's scatter asks for
    bool check = false;
};

constexpr const char* examples = R"(Examples:
  similitude advise data/advice/flour.json --budget "10 min" --tolerance "3 deg"
      which grain, rule and modulus; what is lost, what it costs
  similitude advise data/advice/flour.json --budget "1 min" --tolerance "3 deg" --check --report out/flour.html
      and heaps of that grain beside those of a finer one, to catch the loss)";

constexpr double finer = 1.25;        // the check's grain: the chosen one's diameter over this
constexpr double usual_spread = 3.0;  // deg, where the map has no cell to say
constexpr double most_counted = 3e5;  // grains up to which the cost is that of the setup itself
// Grain sizes over that of the map's reference: finer than all of the map, then its own.
constexpr double factors[] = {3.0, 2.0, 1.5, 1.25, 1.0, 0.7, 0.5, 0.35};

struct Work {
    const cases::Case& c;
    const cases::Experiment& e;
    verify::ScalingMap map;
    verify::PowderGroups powder;
    double budget, tolerance, speed;
    std::string out;
    std::uint64_t seed;
};

const cases::Experiment& pile_of(const cases::Case& c, const std::string& id) {
    const cases::Experiment* e = experiment_of(c, id);
    if (e == nullptr || e->rig != "pile")
        throw InvalidInput(mistake(c.path + ": experiments", e ? e->rig : "none",
                                   "must hold a pile: the map is of piles",
                                   "add one, or name it by --experiment"));
    return *e;
}

ScaleOverrides coarse(double h, const std::string& rule, double softening,
                      const std::string& experiment) {
    ScaleOverrides o;
    o.h = h, o.softening = softening, o.scheme = "coarse_grain", o.experiment = experiment;
    o.invariant = rule == "none" ? "stress_bond" : rule;
    return o;
}

verify::PowderGroups groups_of(const cases::Case& c, const cases::Experiment& e) {
    const scaling::ScaleInput in = scale_input(c, coarse(2.0, "none", 1.0, e.id));
    const double d = in.grain.diameter.value(), rho = in.grain.density.value(),
                 g = in.grain.gravity.value();
    verify::PowderGroups p{e.conditions.at("base_diameter").quantity<scaling::Length>().value() / d,
                           in.grain.youngs_modulus.value() / (rho * g * d), 0.0};
    if (in.adhesion) {
        const double pi = std::numbers::pi,
                     pull_off = 1.5 * pi * in.adhesion->work_of_adhesion.value() * 0.25 * d;
        p.bond = pull_off / (rho * g * pi / 6.0 * d * d * d);
    }
    return p;
}

// The setup of the scaled case, by way of its file: what is costed is what is run.
rigs::PileSetup setup_of(const Work& w, const AdvisedGrain& g, const fs::path& folder,
                         std::vector<std::string>* notes) {
    const ScaledCase scaled = scaled_case(w.c, w.e, {g.h, g.softening, g.work_of_adhesion});
    if (notes) *notes = scaled.notes;
    const cases::Case read = cases::read_case(write_case(scaled, folder));
    return rigs::pile_setup(read, read.experiments.front(), w.seed);
}

AdvisedGrain candidate(const Work& w, const std::string& rule, double h) {
    AdvisedGrain g{};
    g.rule = rule, g.h = h, g.softening = 1.0;
    g.size_ratio = w.powder.size_ratio / h;
    g.coarse = verify::read_coarse(w.map, w.powder, rule, h, w.tolerance);
    // The map's own modulus, where the powder's is stiffer: E' is one for all grains.
    const double at_reference =
        w.powder.elasticity * *verify::finest_size_ratio(w.map) / w.powder.size_ratio;
    const double map_has = *verify::modulus_of_map(w.map);
    g.softening = h > 1.0 ? std::min(1.0, map_has / at_reference) : 1.0;
    g.elasticity = g.softening * w.powder.elasticity / h;
    const scaling::ScaleStudy study = study_of(w.c, coarse(h, rule, g.softening, w.e.id), w.speed);
    if (study.adhesion && w.powder.bond > 0.0) {
        g.work_of_adhesion = study.adhesion->scaled.work_of_adhesion.value();
        g.bond = study.adhesion->scaled.pull_off_in_grain_weights;
        for (const scaling::Finding& f : study.adhesion->findings)
            if (f.judgement == scaling::Judgement::unusable) g.unusable = f.text;
    }
    if (g.softening < 1.0)
        g.soft = verify::read_softening(w.map, at_reference, map_has, g.bond, w.tolerance);
    return g;
}

// Grains as h^-3, steps as h^-1: a contact lasts as its grain is large.
void cost_all(const Work& w, std::vector<AdvisedGrain>& list) {
    AdvisedGrain* first = nullptr;
    for (AdvisedGrain& g : list) {
        const double ratio = first ? first->h / g.h : 1.0;
        const bool few = !first || first->grains * ratio * ratio * ratio < most_counted;
        if (few) {
            const rigs::PileSetup setup = setup_of(w, g, fs::path(w.out) / "considered", nullptr);
            g.grains = static_cast<double>(setup.feed_time.size());
            g.time_step = setup.time_step;
            g.seconds = verify::expected_grain_steps(setup) / w.speed;
            first = &g;
        } else {
            g.grains = first->grains * std::pow(ratio, 3.0);
            g.time_step = first->time_step / ratio;
            g.seconds = first->seconds * std::pow(ratio, 4.0);
        }
        g.affordable = g.seconds <= w.budget;
    }
}

std::vector<AdvisedGrain> considered(const Work& w) {
    const std::optional<double> finest = verify::finest_size_ratio(w.map);
    if (!finest)
        throw InvalidInput(mistake("--map", "no cell of coarse_graining", "must hold some",
                                   "similitude verify scaling-map"));
    std::vector<AdvisedGrain> list;
    for (const double factor : factors) {
        const double h = factor * w.powder.size_ratio / *finest;
        if (h <= 1.0) break;
        for (const verify::CoarseRule& rule : verify::coarse_rules())
            if ((std::string(rule.name) == "none") == (w.powder.bond == 0.0))
                list.push_back(candidate(w, rule.name, h));
    }
    AdvisedGrain own = candidate(w, w.powder.bond > 0.0 ? "stress_bond" : "none", 1.0);
    own.coarse = {};  // the powder itself
    own.coarse.says = verify::AngleSays::within;
    list.push_back(std::move(own));
    cost_all(w, list);
    return list;
}

void plan_check(const Work& w, reports::Advice& a, int seeds) {
    const AdvisedGrain& g = a.considered[*a.chosen];
    const rigs::PileSetup setup = setup_of(w, g, fs::path(w.out) / "advised", &a.notes);
    AdvisedGrain fine = candidate(w, g.rule, g.h / finer);
    fine.softening = g.softening;
    a.finer_h = fine.h;
    a.finer_seconds =
        verify::expected_grain_steps(setup_of(w, fine, fs::path(w.out) / "finer", nullptr)) /
        w.speed;
    a.spread = std::max(g.coarse.spread.value_or(usual_spread), 0.1);
    constexpr double power = 0.8;
    a.seeds = seeds > 0 ? static_cast<std::size_t>(seeds)
                        : statistics::seeds_per_side(a.spread, w.tolerance, power);
    a.next = fmt::format(
        "written: {0}/advised/case.json and {0}/finer/case.json; --check pours both", w.out);
}

// Heaps of the finer grain as reference, of the chosen one beside them.
verify::Comparison checked(const Work& w, const reports::Advice& a, const AdviseOptions& o,
                           Progress& progress) {
    verify::Plan plan;
    std::vector<std::size_t> groups;
    for (const char* which : {"finer", "advised"}) {
        const cases::Case read = cases::read_case((fs::path(w.out) / which).string());
        groups.push_back(
            plan.add(verify::jobs(static_cast<int>(a.seeds), w.seed, [&](std::uint64_t seed) {
                return verify::PileJob{fmt::format("{}-{}", which, seed), seed,
                                       rigs::pile_setup(read, read.experiments.front(), seed)};
            })));
    }
    plan.run(remembered_campaign(o.common, fs::path(w.out) / "heaps", progress, "heaps"));
    const double nu = w.c.grain.poisson_ratio.value.value();
    const AdvisedGrain& g = a.considered[*a.chosen];
    verify::Side sides[2] = {
        verify::side_of(fmt::format("h = {:.4g}", a.finer_h), plan.job(groups[0]), nu),
        verify::side_of(fmt::format("h = {:.4g}", g.h), plan.job(groups[1]), nu)};
    for (std::size_t k = 0; k < 2; ++k) sides[k].samples = plan.samples(groups[k]);
    verify::Margins margins;
    margins.angle_deg = w.tolerance;
    return verify::compare("check", "the grain's size", sides[0], sides[1], margins);
}

int run(const AdviseOptions& o, const std::string& command) {
    const double budget = cases::quantity<scaling::Time>(o.budget, "--budget").value();
    const double tolerance =
        cases::to_si(o.tolerance, cases::parse_unit("rad", "--tolerance"), "--tolerance") * 180.0 /
        std::numbers::pi;
    if (budget <= 0.0 || tolerance <= 0.0)
        throw InvalidInput(mistake(budget <= 0.0 ? "--budget" : "--tolerance",
                                   budget <= 0.0 ? o.budget : o.tolerance, "must be above 0",
                                   "\"2 h\", \"2 deg\""));
    const cases::Case c = cases::read_case(o.path);
    const cases::Experiment& e = pile_of(c, o.experiment);
    watch_interrupts();
    const Work w{c,
                 e,
                 reports::read_scaling_map(o.map),
                 groups_of(c, e),
                 budget,
                 tolerance,
                 measured_speed(1),
                 o.out,
                 o.common.seed};
    reports::Advice a{.title = c.title,
                      .source = c.source,
                      .map = fmt::format("{} ({})", o.map, w.map.extent),
                      .budget = budget,
                      .tolerance = tolerance,
                      .powder = w.powder,
                      .considered = considered(w)};
    a.chosen = verify::choose(a.considered);
    if (a.chosen) plan_check(w, a, o.seeds);
    if (a.chosen && o.check) {
        Progress progress(!o.common.quiet);
        try {
            a.check = checked(w, a, o, progress);
        } catch (const verify::Interrupted&) {
            fmt::print(stderr, "similitude: interrupted; the same command with --resume goes on\n");
            return interrupted;
        }
    }
    const reports::Provenance who = provenance(command, c.path);
    print(o.common, reports::text_of(a));
    write_results(o.common, reports::to_json(a, who), [&] { return reports::page_of(a, who); });
    return exit_code_of(reports::verdict_of(a).answer);
}

}  // namespace

Verb advise_verb(CLI::App& app, const std::string& command) {
    const auto options = std::make_shared<AdviseOptions>();
    CLI::App* verb = app.add_subcommand(
        "advise", "which grain to simulate in place of the powder's, what is lost, what it costs");
    verb->add_option("CASE", options->path, "case.json or its folder")->required();
    verb->add_option("--budget", options->budget,
                     "time that one heap may take on one core: \"2 h\"")
        ->required()
        ->type_name("TIME");
    verb->add_option("--tolerance", options->tolerance,
                     "by which the angle of repose may move: \"2 deg\"")
        ->required()
        ->type_name("ANGLE");
    verb->add_option("--experiment", options->experiment, "which pile; the first one otherwise");
    verb->add_option("--map", options->map, "what verify scaling-map wrote by --json")
        ->type_name("FILE")
        ->capture_default_str();
    verb->add_option("--out", options->out, "folder of the cases written and of the check's heaps")
        ->type_name("DIR")
        ->capture_default_str();
    verb->add_flag("--check", options->check,
                   "pour heaps of the advised grain and of a finer one, and compare");
    verb->add_option("--seeds", options->seeds,
                     "heaps a side of the check; otherwise what the scatter asks for")
        ->check(CLI::Range(2, 1000));
    add_common(*verb, options->common);
    verb->footer(examples);
    return {verb, [options, command] { return run(*options, command); }};
}

}  // namespace app
