// SPDX-License-Identifier: MIT
#include "app/lammps_base.hpp"

#include "app/forward_curves.hpp"
#include "cases/units.hpp"
#include "engines/lammps_one_grain.hpp"
#include "engines/lammps_run.hpp"
#include "engines/one_throw.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace app {
namespace {

// A recording sees more of a step than a picture does: at the decks' own 100 steps to a contact a bead of 4 mm bounces 0.1 mm off the
// resolved path (docs/diagnose.md).
constexpr double finer = 5.0;

using cases::Case;
using cases::Experiment;

[[noreturn]] void refuse(const std::string& rule, const std::string& remedy) {
    throw scaling::InvalidInput(scaling::mistake("--engine", "lammps", rule, remedy));
}

void add(std::string& list, const std::string& id) { list += (list.empty() ? "" : ", ") + id; }

}  // namespace

LammpsBase simulate_base_in_lammps(
    Case& c, const std::filesystem::path& folder,
    const std::function<void(std::size_t, std::size_t, const std::string&)>& show) {
    std::vector<Experiment*> to_run;
    std::string run_here, run_there;
    double step = std::numeric_limits<double>::infinity();
    for (Experiment& e : c.experiments) {
        if (e.held_out || !e.recording) continue;
        if (!engines::is_thrown(e)) {
            add(run_here, fmt::format("{} ({})", e.id, e.rig));
            continue;
        }
        if (e.simulated)
            refuse("would take the place of your own run of " + e.id,
                   "leave the option out, or take `simulated` out of the case");
        step = std::min(step, engines::lammps_time_step(c, e));
        to_run.push_back(&e);
        add(run_there, e.id);
    }
    if (to_run.empty())
        refuse("runs drops, inclines and impacts as a base, and no such recording is fitted",
               "leave the option out: this tool's own model is the base");
    if (!c.model.numerics.time_step) step /= finer;
    c.model.numerics.time_step = scaling::Time::from_value(step);
    const std::filesystem::path lmp = engines::lammps_program("--engine");
    LammpsBase base{false, {}};
    std::string release;
    for (std::size_t k = 0; k < to_run.size(); ++k) {
        Experiment& e = *to_run[k];
        show(k, to_run.size(), e.id);
        const rigs::Ordinates at = rigs::recorded_ordinates(e);
        const engines::PeerCurvesRun run = engines::run_one_grain(
            *engines::find_peer("lammps"), lmp, c, e, at, folder / (e.id + "-lammps"));
        if (run.interrupted) return {true, {}};
        e.simulated = cases::Recording{curve_columns(e, run.curves, at)};
        release = run.release;
    }
    base.statements.push_back(
        fmt::format("Your own run of {} was made here by LAMMPS {}, in steps of {}.", run_there,
                    release, cases::format_si(step, "s")));
    if (!run_here.empty())
        base.statements.push_back(fmt::format(
            "The base simulation of {} is this tool's own: LAMMPS lets go before JKR's fold.", run_here));
    return base;
}

}  // namespace app
