// SPDX-License-Identifier: MIT
#include "app/pile_task.hpp"

#include "app/pile_status.hpp"

#include <algorithm>

namespace app {

namespace {

// What holds every grain of the rig that has not yet fallen off.
Box box_of(const rigs::PileSetup& setup) {
    const rigs::PileConditions& c = setup.conditions;
    double width = std::max(c.base_diameter, c.feed_diameter), top = c.drop_height;
    if (c.funnel) {
        width = std::max(width, c.funnel->top_diameter);
        top = c.funnel->outlet_height + c.funnel->height;
    }
    return {{-0.5 * width, -0.5 * width, setup.lost_below}, {0.5 * width, 0.5 * width, top}};
}

nlohmann::json state_of(const rigs::PileRun& run) {
    return {{"still_since", run.still_since},
            {"fed", run.fed},
            {"while_fed", {run.while_fed.asked, run.while_fed.slept}},
            {"at_rest", run.at_rest},
            {"finished", run.finished}};
}

void take_state(rigs::PileRun& run, const nlohmann::json& j) {
    run.still_since = j.at("still_since");
    run.fed = j.at("fed");
    run.while_fed = {j.at("while_fed").at(0), j.at("while_fed").at(1)};
    run.at_rest = j.at("at_rest");
    run.finished = j.at("finished");
}

}  // namespace

PileOutcome run_pile(const PileTask& task) {
    rigs::PileRun run = rigs::begin_pile(task.setup, task.plan.threads);
    const std::size_t glued = run.simulation.grains.count();
    const RunOutcome outcome = carry_out(
        task.plan, {.simulation = run.simulation,
                    .box = box_of(task.setup),
                    .expected_steps = rigs::expected_steps(task.setup),
                    .advance = [&](std::int64_t steps) { rigs::advance(run, task.setup, steps); },
                    .finished = [&] { return run.finished; },
                    .work = [&](double steps) { return expected_work(task.setup, glued, steps); },
                    .status =
                        [&](double speed, double awake) {
                            return pile_status(task.plan.id, run, task.setup, speed, awake);
                        },
                    .state = [&] { return state_of(run); },
                    .take_state = [&](const nlohmann::json& j) { take_state(run, j); }});
    if (!outcome.finished) return {std::nullopt, outcome};
    return {rigs::record(run, task.setup), outcome};
}

}  // namespace app
