// SPDX-License-Identifier: MIT
#include "rigs/grain_sizes.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace rigs {
namespace {

using scaling::Length;

// The diameter at which a share `u` of all grains is smaller, of a distribution given by volume. Between two stated points the
// volume is spread evenly over the diameter, hence the number as d^-3; what lies below the first and above the last is not
// stated and left out.
double diameter_by_number(const std::vector<std::pair<double, Length>>& cumulative, double u) {
    std::vector<double> number(cumulative.size(), 0.0);
    const auto inverse_square = [&](std::size_t k) {
        return 1.0 / (cumulative[k].second.value() * cumulative[k].second.value());
    };
    for (std::size_t k = 1; k < cumulative.size(); ++k) {
        const double width = cumulative[k].second.value() - cumulative[k - 1].second.value();
        number[k] = number[k - 1] + (cumulative[k].first - cumulative[k - 1].first) / width *
                                        (inverse_square(k - 1) - inverse_square(k));
    }
    const double wanted = u * number.back();
    std::size_t k = 1;
    while (k + 1 < number.size() && number[k] < wanted) ++k;
    const double share = (wanted - number[k - 1]) / (number[k] - number[k - 1]);
    return 1.0 /
           std::sqrt(inverse_square(k - 1) - share * (inverse_square(k - 1) - inverse_square(k)));
}

// Log-normal by number, cut off at `cut` of its deviations: mean d before the cut, deviation `spread` times the mean.
double log_normal_diameter(double d, double spread, double u) {
    constexpr double cut = 2.5;
    const double deviation = std::sqrt(std::log1p(spread * spread));
    const double below = 0.5 * std::erfc(cut / std::numbers::sqrt2);
    const double wanted = below + u * (1.0 - 2.0 * below);
    double low = -cut, high = cut;  // of the normal deviate, halved down to its last bits
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (0.5 * std::erfc(-middle / std::numbers::sqrt2) < wanted ? low : high) = middle;
    }
    return d * std::exp(deviation * 0.5 * (low + high) - 0.5 * deviation * deviation);
}

}  // namespace

DrawnGrain draw_grain(const cases::Grain& grain, double u, double size_spread) {
    if (size_spread > 0.0)
        return {log_normal_diameter(grain.diameter.value.value(), size_spread, u),
                cases::material_of_grain};
    if (!grain.size_distribution.empty())
        return {diameter_by_number(grain.size_distribution, u), cases::material_of_grain};
    if (grain.sizes.empty()) return {grain.diameter.value.value(), cases::material_of_grain};
    double below = grain.sizes.front().second;
    std::size_t k = 0;
    while (k + 1 < grain.sizes.size() && u >= below) below += grain.sizes[++k].second;
    return {grain.sizes[k].first.value(), grain.size_material[k]};
}

}  // namespace rigs
