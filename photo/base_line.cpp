// SPDX-License-Identifier: MIT
#include "photo/base_line.hpp"

#include <algorithm>
#include <cmath>

namespace photo {
namespace {

constexpr double steepest = 0.36;  // 20 deg: nobody holds a camera worse than that

struct Support {
    std::size_t left = 0, right = 0, under = 0;
};

Support support(const Line& line, const std::vector<Pixel>& edge, std::size_t step,
                double tolerance, double middle) {
    Support s;
    for (std::size_t k = 0; k < edge.size(); k += step) {
        const double below = edge[k].y - line.y(edge[k].x);  // y points down
        if (below > 2.0 * tolerance) ++s.under;
        if (std::abs(below) <= tolerance) ++(edge[k].x < middle ? s.left : s.right);
    }
    return s;
}

}  // namespace

std::optional<BaseLine> find_base_line(const std::vector<Pixel>& edge, std::size_t width) {
    if (edge.size() < 16) return std::nullopt;
    const double tolerance = std::max(1.5, 0.002 * static_cast<double>(width));
    const double middle = 0.5 * (edge.front().x + edge.back().x);
    const std::size_t step = std::max<std::size_t>(1, edge.size() / 150);

    // === The line of a pair that most points lie on; the rarer side counts
    Line best{0.0, 0.0};
    std::size_t most = 0;
    for (std::size_t a = 0; a < edge.size() && edge[a].x < middle; a += step)
        for (std::size_t b = edge.size() - 1; b > a && edge[b].x > middle; b -= std::min(b, step)) {
            const double slope = (edge[b].y - edge[a].y) / (edge[b].x - edge[a].x);
            if (std::abs(slope) > steepest) continue;
            const Line line{edge[a].y - slope * edge[a].x, slope};
            const Support s = support(line, edge, step, tolerance, middle);
            if (20 * s.under > edge.size() / step) continue;
            const std::size_t score = 4 * std::min(s.left, s.right) + s.left + s.right;
            if (score > most) most = score, best = line;
        }
    if (most == 0) return std::nullopt;

    // === Least squares through what lies on it
    BaseLine found{best, 0.0, 0.0};
    for (int round = 0; round < 5; ++round) {
        double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, squares = 0.0;
        for (const Pixel& p : edge) {
            if (std::abs(p.y - found.line.y(p.x)) > tolerance) continue;
            n += 1.0, x += p.x, y += p.y;
        }
        x /= n, y /= n;
        for (const Pixel& p : edge) {
            if (std::abs(p.y - found.line.y(p.x)) > tolerance) continue;
            xx += (p.x - x) * (p.x - x), xy += (p.x - x) * (p.y - y);
        }
        if (n < 16.0 || !(xx > 0.0)) return std::nullopt;
        found.line.slope = xy / xx;
        found.line.level = y - found.line.slope * x;
        for (const Pixel& p : edge) {
            const double e = p.y - found.line.y(p.x);
            if (std::abs(e) <= tolerance) squares += e * e;
        }
        // Neighbouring columns share their noise (JPEG works in blocks of eight): one in eight counts as independent. At least a tenth of a
        // pixel, which no edge is better than.
        const double scatter = std::sqrt(std::max(squares / (n - 2.0), 0.01)), effective = n / 8.0;
        found.slope_error = scatter / std::sqrt(xx / 8.0);
        found.level_error = scatter / std::sqrt(effective);
    }
    const Support s = support(found.line, edge, 1, tolerance, middle);
    const std::size_t least = std::max<std::size_t>(8, width / 50);
    if (s.left < least || s.right < least || 20 * s.under > edge.size()) return std::nullopt;
    return found;
}

}  // namespace photo
