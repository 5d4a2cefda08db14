// SPDX-License-Identifier: MIT
#include "app/calibration_runs.hpp"

#include "app/lammps_cost.hpp"
#include "app/pile_cost.hpp"
#include "cases/csv.hpp"
#include "cases/messages.hpp"
#include "reports/numbers.hpp"
#include "scaling/errors.hpp"
#include "verify/pile_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <utility>

namespace app {

namespace {

using calibrate::Calibration;
using calibrate::Request;
using calibrate::Run;
using scaling::InvalidInput;
using scaling::mistake;

const cases::Experiment& pile_of(const cases::Case& c, const std::string& id) {
    std::vector<std::string> piles;
    const cases::Experiment* chosen = nullptr;
    for (const cases::Experiment& e : c.experiments) {
        if (e.rig != "pile") continue;
        piles.push_back(e.id);
        if (id.empty() ? chosen == nullptr && e.recording.has_value() : e.id == id) chosen = &e;
    }
    if (chosen != nullptr) return *chosen;
    if (id.empty())
        throw InvalidInput(
            mistake(c.path + ": experiments", "no pile with a recording",
                    "must hold one to calibrate against",
                    "give a pile a recording of angle_of_repose, or of azimuth, r and z"));
    throw InvalidInput(
        mistake("--experiment", cases::in_quotes(id), "must be a pile of this case",
                piles.empty() ? "this case has none" : cases::suggestion(id, piles)));
}

cases::Case with_cap(cases::Case c, const std::string& name) {
    if (name.empty()) return c;
    const std::vector<std::string>& known = cases::friction_caps();
    if (std::find(known.begin(), known.end(), name) == known.end())
        throw InvalidInput(mistake("--friction-cap", cases::in_quotes(name),
                                   "must be one that contact laws have",
                                   cases::suggestion(name, known)));
    c.model.friction_cap = name;
    return c;
}

// Of the grains that were fed, m: heights are remembered in diameters.
double mean_diameter(const rigs::PileSetup& s) {
    return 2.0 * std::accumulate(s.radius.begin(), s.radius.end(), 0.0) /
           static_cast<double>(s.radius.size());
}

std::vector<double> times(std::vector<double> list, double factor) {
    for (double& x : list) x *= factor;
    return list;
}

// One calibration: what it is made of, and the runs so far.
class Campaign {
  public:
    Campaign(const cases::Case& c, const RoadOptions& o, const CalibrationWatch& watch)
        : options_(o),
          case_(with_cap(c, o.friction_cap)),
          pile_(pile_of(case_, o.experiment)),
          choice_(choice_of(o.heaps)),
          remembered_(o.out.empty() ? o.out : o.out / "similitude-heaps"),
          engine_(engine_of(choice_, remembered_)),
          watch_(watch) {
        result_.pile = calibrate::pile_problem(case_, pile_, {o.estimator, o.bulk_density}, o.seed);
        calibrate::check(result_.pile.problem);
        refuse_cost();
        if (!o.resume && !remembered_.empty()) std::filesystem::remove_all(remembered_);
    }

    // Throws verify::Interrupted.
    Calibration run() {
        for (std::vector<Request> asked = next(); !asked.empty(); asked = next()) {
            for (Run& run : poured(asked)) result_.history.push_back(std::move(run));
            write_runs();
        }
        note_failures();
        return std::move(result_);
    }

  private:
    bool given() const { return !options_.at.empty(); }
    bool paper() const { return options_.road == "paper"; }
    calibrate::PaperOptions paper_options() const { return {.confirmations = options_.confirm}; }
    int most_runs() const {
        if (given()) return options_.confirm;
        return paper() ? calibrate::most_runs(result_.pile.problem, paper_options())
                       : options_.budget + options_.confirm;
    }

    // What the road wants next; nothing once it has its answer.
    std::vector<Request> next() {
        const calibrate::Problem& p = result_.pile.problem;
        if (given()) {
            result_.given = calibrate::stated_point(case_, p, options_.at);
            std::vector<Request> all;
            for (int k = 0; result_.history.empty() && k < options_.confirm; ++k)
                all.push_back(
                    {*result_.given, p.seed + static_cast<std::uint64_t>(k), "confirming"});
            return all;
        }
        if (paper()) {
            calibrate::PaperStep step = calibrate::next(p, paper_options(), result_.history);
            result_.paper = step.result;
            return step.requests;
        }
        calibrate::SurrogateStep step = calibrate::next(
            p, {.budget = most_runs(), .batch = options_.batch, .confirmations = options_.confirm},
            result_.history);
        result_.surrogate = step.result;
        return step.requests;
    }

    rigs::PileSetup setup_of(const Request& r) const {
        const cases::Case there = calibrate::at_point(case_, result_.pile.problem, r.point);
        return chosen_setup(there, *there.find(pile_.id), r.seed, options_.yes, choice_);
    }

    void refuse_cost() const {
        const rigs::PileSetup one =
            chosen_setup(case_, pile_, options_.seed, options_.yes, choice_);
        if (options_.yes) return;
        const double of_one = choice_.peer != nullptr ? lammps_cost(one, choice_.ranks).seconds
                                                      : seconds_of(one, 1) / options_.threads;
        const double seconds = of_one * most_runs();
        if (seconds > longest_unasked)
            throw InvalidInput(mistake(
                "experiment " + cases::in_quotes(pile_.id),
                fmt::format("{} heaps, about {} on this machine", most_runs(),
                            reports::quantity(seconds, "s")),
                "must not need more than 12 h unasked",
                "take fewer or larger grains (similitude scale), fewer runs, or say --yes"));
    }

    verify::Campaign side_by_side() {
        const double before = static_cast<double>(result_.history.size());
        const double all = most_runs();
        return {.threads = options_.threads,
                .engine = engine_.get(),
                .remembered_in = remembered_,
                .progress =
                    [this, before, all](double done, double of, const std::string& ended) {
                        watch_.progress(before + done / of * asked_, all, ended);
                    },
                .stop = watch_.stop};
    }

    std::vector<Run> poured(const std::vector<Request>& asked) {
        std::vector<verify::PileJob> jobs;
        for (const Request& r : asked)
            jobs.push_back({.name = fmt::format("{}-{}", r.stage, r.seed),
                            .seed = r.seed,
                            .setup = setup_of(r)});
        asked_ = static_cast<double>(jobs.size());
        std::vector<Run> runs;
        const double density = pile_.grain.density.value.value();
        for (const verify::PileSample& s : verify::run_piles(jobs, side_by_side())) {
            for (const std::string& criterion : s.missed) ++missed_[criterion];
            const double d = mean_diameter(jobs[runs.size()].setup);
            runs.push_back(
                {asked[runs.size()], calibrate::values_of(result_.pile,
                                                          {.formed = s.formed,
                                                           .at_rest = s.at_rest,
                                                           .angles = s.angles_deg,
                                                           .packing_fraction = s.packing_fraction,
                                                           .profile_r = times(s.profile_r, d),
                                                           .profile_z = times(s.profile_z, d)},
                                                          density)});
            unread_ += s.formed && s.at_rest && !runs.back().values;
        }
        return runs;
    }

    // What the heaps that do not count failed at.
    void note_failures() {
        const std::size_t heaps = result_.history.size();
        std::string missed;
        for (const auto& [criterion, count] : missed_)
            missed += fmt::format("{}{} ({})", missed.empty() ? "" : ", ",
                                  reports::words(criterion), count);
        if (!missed.empty())
            result_.pile.notes.push_back(fmt::format(
                "of {} heaps so many fail at a criterion, some at several: {}", heaps, missed));
        if (unread_ > 0)
            result_.pile.notes.push_back(fmt::format(
                "{} of {} heaps formed, but not every target could be read from them: they count "
                "as not formed",
                unread_, heaps));
    }

    void write_runs() const {
        if (options_.out.empty()) return;
        const calibrate::Problem& p = result_.pile.problem;
        cases::Column seed{"seed", "1"}, formed{"formed", "1"}, stage{"stage", ""};
        std::vector<cases::Column> columns;
        for (const calibrate::Factor& f : p.factors) columns.push_back({f.name, f.unit});
        for (const calibrate::Target& t : p.targets) columns.push_back({t.name, t.unit});
        for (const Run& run : result_.history) {
            seed.values.push_back(static_cast<double>(run.request.seed));
            stage.words.push_back(run.request.stage);
            formed.values.push_back(run.values ? 1.0 : 0.0);
            for (std::size_t k = 0; k < p.factors.size(); ++k)
                columns[k].values.push_back(run.request.point[static_cast<Eigen::Index>(k)]);
            for (std::size_t k = 0; k < p.targets.size(); ++k)
                columns[p.factors.size() + k].values.push_back(run.values ? (*run.values)[k]
                                                                          : std::nan(""));
        }
        columns.insert(columns.begin(), {stage, seed, formed});
        cases::write_csv((options_.out / "runs.csv").string(), columns);
    }

    const RoadOptions& options_;
    const cases::Case case_;
    const cases::Experiment& pile_;
    EngineChoice choice_;
    std::filesystem::path remembered_;
    std::unique_ptr<rigs::PileEngine> engine_;  // none: our own core
    const CalibrationWatch& watch_;
    Calibration result_{};
    std::map<std::string, int> missed_;  // criterion of a heap, how many failed at it
    int unread_ = 0;                     // heaps that formed, without a value of each target
    double asked_ = 1.0;                 // heaps of the batch that is being poured
};

}  // namespace

calibrate::Calibration calibration(const cases::Case& c, const RoadOptions& o,
                                   const CalibrationWatch& watch) {
    if (o.road != "surrogate" && o.road != "paper")
        throw InvalidInput(mistake("--road", cases::in_quotes(o.road), "must be surrogate or paper",
                                   "surrogate is the default"));
    if (!o.at.empty() && o.road != "surrogate")
        throw InvalidInput(mistake("--road", cases::in_quotes(o.road), "must not stand beside --at",
                                   "a given point takes no road"));
    if (!o.at.empty() && o.confirm == 0)
        throw InvalidInput(mistake("--confirm", "0", "must be at least 1 beside --at",
                                   "these are the heaps that are poured there"));
    return Campaign(c, o, watch).run();
}

}  // namespace app
