// SPDX-License-Identifier: MIT
// Prints the table of biases of docs/angle-of-repose.md; runs only when named: build/test_rigs "[table]".
#include "rigs/angle_of_repose.hpp"
#include "synthetic_heap.hpp"

#include <catch2/catch.hpp>
#include <fmt/core.h>

#include <cmath>
#include <numbers>

TEST_CASE("table: bias of every estimator on cones of known angle", "[.][table]") {
    const double deg = std::numbers::pi / 180.0;
    fmt::print("| d/D | angle | flank_20_80 | cone | two_h_over_d | silhouette | volume |\n");
    for (const int across : {10, 20, 50, 200}) {
        for (const int angle : {15, 30, 45, 55, 65}) {
            const double tangent = std::tan(angle * deg);
            synthetic::Shape shape = synthetic::cone(0.5 * across, tangent);
            shape.shell = 3.0 * std::hypot(1.0, tangent);
            const int heaps = across == 200 ? 2 : 12;
            std::string line = fmt::format("| 1/{} | {} |", across, angle);
            double sum[5] = {}, squares[5] = {};
            int count[5] = {};
            for (int seed = 1; seed <= heaps; ++seed) {
                const rigs::HeightMap map =
                    rigs::scan(synthetic::heap(shape, static_cast<std::uint64_t>(seed)));
                for (std::size_t e = 0; e < rigs::computed_estimators.size(); ++e) {
                    const auto a = rigs::angle_of_repose(map, rigs::computed_estimators[e]);
                    if (!a) continue;
                    const double bias = a->angle / deg - angle;
                    sum[e] += bias, squares[e] += bias * bias, ++count[e];
                }
            }
            for (int e = 0; e < 5; ++e) {
                const double mean = sum[e] / count[e];
                line += fmt::format(
                    " {:+.1f} ± {:.1f}{} |", mean,
                    std::sqrt(std::max(0.0, squares[e] / count[e] - mean * mean)),
                    count[e] < heaps ? fmt::format(" ({} of {})", count[e], heaps) : "");
            }
            fmt::print("{}\n", line);
            std::fflush(stdout);
        }
    }
}
