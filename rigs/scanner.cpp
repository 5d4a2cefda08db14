// SPDX-License-Identifier: MIT
#include "rigs/scanner.hpp"

#include <algorithm>
#include <cmath>

namespace rigs {

std::vector<double> heights_at(const Heap& heap, const std::vector<double>& azimuth,
                               const std::vector<double>& r) {
    std::vector<double> z(r.size(), 0.0);
    if (heap.radius.empty()) return z;
    // Grains by squares of the largest diameter: what can lie above a spot is in its square or in one of the eight about it.
    const double square = 2.0 * *std::max_element(heap.radius.begin(), heap.radius.end());
    double reach = 0.0;
    for (const contact::Vec3& c : heap.centre)
        reach = std::max({reach, std::abs(c.x), std::abs(c.y)});
    const auto side = static_cast<long>(std::ceil(2.0 * reach / square)) + 3;
    const auto place = [&](double x) {
        return static_cast<long>(std::floor((x + reach) / square)) + 1;
    };
    std::vector<std::vector<std::size_t>> grains(static_cast<std::size_t>(side * side));
    for (std::size_t g = 0; g < heap.radius.size(); ++g)
        grains[static_cast<std::size_t>(place(heap.centre[g].x) * side + place(heap.centre[g].y))]
            .push_back(g);
    for (std::size_t k = 0; k < r.size(); ++k) {
        const double x = r[k] * std::cos(azimuth[k]), y = r[k] * std::sin(azimuth[k]);
        const long i = place(x), j = place(y);
        for (long a = std::max(0L, i - 1); a <= std::min(side - 1, i + 1); ++a)
            for (long b = std::max(0L, j - 1); b <= std::min(side - 1, j + 1); ++b)
                for (const std::size_t g : grains[static_cast<std::size_t>(a * side + b)]) {
                    const double dx = x - heap.centre[g].x, dy = y - heap.centre[g].y;
                    const double half2 = heap.radius[g] * heap.radius[g] - dx * dx - dy * dy;
                    if (half2 > 0.0) z[k] = std::max(z[k], heap.centre[g].z + std::sqrt(half2));
                }
    }
    return z;
}

}  // namespace rigs
