// SPDX-License-Identifier: MIT
#include "app/flow_task.hpp"

#include "reports/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace app {

namespace {

// What holds every grain that begins to fall, and as much room beside it.
Box box_of(const rigs::FlowSetup& setup) {
    Box box{{0.0, 0.0, 0.0}, {setup.d, setup.d, setup.d}};
    for (const contact::Vec3 at : setup.place) {
        box.low = {std::min(box.low.x, at.x), std::min(box.low.y, at.y), std::min(box.low.z, at.z)};
        box.high = {std::max(box.high.x, at.x), std::max(box.high.y, at.y),
                    std::max(box.high.z, at.z)};
    }
    return box;
}

nlohmann::json state_of(const rigs::FlowState& s) {
    return {{"still_since", s.still_since}, {"released", s.released}, {"last_out", s.last_out},
            {"levelled", s.levelled},       {"finished", s.finished}, {"ending", s.ending},
            {"looked", s.looked},           {"rows", s.rows},         {"noted", s.noted}};
}

rigs::FlowState state_from(const nlohmann::json& j) {
    return {j.at("still_since"), j.at("released"), j.at("last_out"),
            j.at("levelled"),    j.at("finished"), j.at("ending"),
            j.at("looked"),      j.at("rows"),     j.at("noted")};
}

std::string status_of(const std::string& id, const rigs::FlowRun& run, const rigs::FlowSetup& setup,
                      double speed) {
    using reports::count, reports::number, reports::quantity;
    const dem_min::Simulation& s = run.simulation;
    const bool flows = run.state.released >= 0;
    const double since =
        static_cast<double>(s.steps - (flows ? run.state.released : 0)) * setup.time_step;
    return fmt::format(
        "{}: step {}, {} {}, {} grains, kinetic {}, overlap {} % of R*, {} contacts/grain, {} "
        "grain-steps/s",
        id, count(static_cast<double>(s.steps)), flows ? "t =" : "poured for", quantity(since, "s"),
        count(static_cast<double>(s.grains.count())), quantity(dem_min::kinetic_energy(s), "J"),
        number(100.0 * dem_min::largest_overlap(s)), number(dem_min::mean_coordination(s)),
        number(speed));
}

}  // namespace

FlowOutcome run_flow(const FlowTask& task) {
    const rigs::FlowSetup& setup = task.setup;
    rigs::FlowRun run = rigs::begin_flow(setup, task.plan.threads);
    const auto grains = static_cast<double>(setup.place.size());
    const RunOutcome outcome = carry_out(
        task.plan,
        {.simulation = run.simulation,
         .box = box_of(setup),
         .expected_steps = rigs::expected_steps(setup),
         .advance = [&](std::int64_t steps) { rigs::advance(run, setup, steps); },
         .finished = [&] { return run.state.finished; },
         .work = [&](double steps) { return grains * steps; },
         .status = [&](double speed, double) { return status_of(task.plan.id, run, setup, speed); },
         .state = [&] { return state_of(run.state); },
         .take_state = [&](const nlohmann::json& j) { rigs::restore(run, setup, state_from(j)); }});
    if (!outcome.finished) return {std::nullopt, outcome};
    return {rigs::record(run, setup), outcome};
}

}  // namespace app
