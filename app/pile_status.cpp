// SPDX-License-Identifier: MIT
#include "app/pile_status.hpp"

#include "reports/numbers.hpp"

#include <fmt/format.h>

namespace app {

double expected_work(const rigs::PileSetup& setup, std::size_t glued, double steps) {
    const double feeding = setup.feed_time.back() / setup.time_step;  // steps; grains come evenly
    const double fed =
        static_cast<double>(setup.feed_time.size() * rigs::spheres_per_grain(setup));  // spheres
    const double by_fed =
        steps < feeding ? fed * steps * steps / (2.0 * feeding) : fed * (steps - 0.5 * feeding);
    return static_cast<double>(glued) * steps + by_fed;
}

std::string pile_status(const std::string& id, const rigs::PileRun& run,
                        const rigs::PileSetup& setup, double speed, double awake) {
    using reports::count, reports::number, reports::quantity;
    const dem_min::Simulation& s = run.simulation;
    return fmt::format(
        "{}: step {}, {}, {}/{} fed, {} lost, kinetic {}, overlap {} % of R*, {} contacts/grain, "
        "{} grain-steps/s{}",
        id, count(static_cast<double>(s.steps)), quantity(s.time(), "s"),
        count(static_cast<double>(run.fed)), count(static_cast<double>(setup.feed_time.size())),
        count(static_cast<double>(s.past.grains_lost)), quantity(dem_min::kinetic_energy(s), "J"),
        number(100.0 * dem_min::largest_overlap(s)), number(dem_min::mean_coordination(s)),
        number(speed),
        setup.sleep_speed > 0.0 ? fmt::format(", {} % awake", number(100.0 * awake)) : "");
}

}  // namespace app
