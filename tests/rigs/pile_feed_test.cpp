// SPDX-License-Identifier: MIT
// Where grains appear: at the drop height, however many came before, as long as the heap is far below it.
#include "cases/read_case.hpp"
#include "rigs/pile.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

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

// docs/effects.md: log-normal by number, cut off at 2.5 deviations of the logarithm. Its moments by Simpson's rule.
TEST_CASE("polydispersity draws the sizes that its spread says", "[rigs][pile][feed]") {
    const double spread = 0.3, deviation = std::sqrt(std::log1p(spread * spread));
    double weight = 0.0, mean = 0.0, square = 0.0;
    constexpr int steps = 1000;
    for (int k = 0; k <= steps; ++k) {
        const double t = -2.5 + 5.0 * k / steps, simpson = k == 0 || k == steps ? 1 : k % 2 ? 4 : 2;
        const double p = simpson * std::exp(-0.5 * t * t);
        const double size = std::exp(deviation * t - 0.5 * deviation * deviation);
        weight += p, mean += p * size, square += p * size * size;
    }
    mean /= weight, square /= weight;
    cases::Case c = cases::read_case("data/zirconia/heap-50mm.json");
    cases::Experiment& e = c.experiments.at(0);
    e.grain.sizes.clear(), e.grain.size_distribution.clear();
    c.model.physics.push_back("polydispersity");
    c.model.parameters["size_spread"] = {spread, "1", {}};
    rigs::PileSetup s = rigs::pile_setup(c, e, 1);
    constexpr int count = 20000;
    s.conditions.grains = count;
    rigs::choose_feed(s, e.grain, 1, spread);
    double drawn_mean = 0.0, drawn_square = 0.0;
    for (const double r : s.radius) {
        const double size = 2.0 * r / e.grain.diameter.value.value();
        drawn_mean += size / count, drawn_square += size * size / count;
    }
    // Five standard errors of a mean of 20000: 5 x 0.3/141 = 0.011; of the squares some four times that.
    CHECK(drawn_mean == Approx(mean).margin(0.011));
    CHECK(drawn_square == Approx(square).margin(0.04));
    CHECK(mean == Approx(1.0).margin(0.01));  // the cut takes less than a hundredth
    e.grain.sizes = {{e.grain.diameter.value, 1.0}};
    e.grain.size_material = {0};
    CHECK_THROWS_WITH(rigs::pile_setup(c, e, 1), Catch::Contains("polydispersity"));
}
