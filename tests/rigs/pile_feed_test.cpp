// SPDX-License-Identifier: MIT
// Where grains appear: at the drop height, however many came before, as long as the heap is far below it.
#include "cases/read_case.hpp"
#include "rigs/pile.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

TEST_CASE("a stream that is dense at its source does not lift its own source",
          "[rigs][pile][feed]") {
    const cases::Case c = cases::read_case("data/zirconia/heap-50mm.json");
    rigs::PileSetup s = rigs::pile_setup(c, c.experiments.at(0), 1);
    // 600 grains, softer by 100: steps are ten times longer.
    s.conditions.grains = 600;
    for (rigs::ContactParameters* laws : {&s.grains, &s.walls})
        laws->e_star *= 0.01, laws->g_star *= 0.01, laws->work_of_adhesion *= 0.1;
    rigs::choose_feed(s, c.grain, 1);
    rigs::choose_steps(s);
    rigs::PileRun run = rigs::begin_pile(s, 1);
    double first_half = 0.0, second_half = 0.0;  // m, highest grain
    while (run.fed < 600) {
        rigs::advance(run, s, 50);
        const auto& z = run.simulation.grains.z;
        double& highest = run.fed < 300 ? first_half : second_half;
        if (!z.empty()) highest = std::max(highest, *std::max_element(z.begin(), z.end()));
    }
    // 600 grains are no heap of 65 mm. Grains that find their place taken appear above it, so that the source is some diameters
    // deep; 5 d: its depth scatters by a few.
    CHECK(first_half < s.conditions.drop_height + 20.0 * s.d);
    CHECK(second_half < first_half + 5.0 * s.d);
}
