// SPDX-License-Identifier: MIT
#include "photo/base_line.hpp"

#include <algorithm>
#include <cmath>

namespace photo {
namespace {

constexpr double steepest = 0.36;  // 20 deg: nobody holds a camera worse than that

struct Support {
    std::size_t left = 0, right = 0, under = 0;
    double score =
        0.0;  // 1 for a point on the line, 0 from the tolerance on: a loose line through many points does not beat a good one
};

Support support(const Line& line, const std::vector<Pixel>& edge, std::size_t step,
                double tolerance, double middle) {
    Support s;
    for (std::size_t k = 0; k < edge.size(); k += step) {
        const double below = edge[k].y - line.y(edge[k].x);  // y points down
        if (below > 2.0 * tolerance) ++s.under;
        if (std::abs(below) > tolerance) continue;
        ++(edge[k].x < middle ? s.left : s.right);
        s.score += 1.0 - below * below / (tolerance * tolerance);
    }
    return s;
}

// Slope and standard error of the points near `line`: least squares, and a jackknife that leaves out an eighth of them at a time, neighbours together.
struct Slope {
    double level, slope, slope_error, scatter;
};

std::optional<Slope> fitted(const Line& line, const std::vector<Pixel>& edge, double tolerance,
                            double middle) {
    std::vector<Pixel> near;
    for (const Pixel& p : edge)
        if (std::abs(p.y - line.y(p.x)) <= tolerance) near.push_back(p);
    if (near.size() < 16) return std::nullopt;
    constexpr std::size_t parts = 8;
    const auto without = [&](std::size_t part) {
        double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
        const auto each = [&](auto use) {
            for (std::size_t k = 0; k < near.size(); ++k)
                if (parts * k / near.size() != part) use(near[k]);
        };
        each([&](const Pixel& p) { n += 1.0, x += p.x, y += p.y; });
        x /= n, y /= n;
        each([&](const Pixel& p) { xx += (p.x - x) * (p.x - x), xy += (p.x - x) * (p.y - y); });
        return Line{y - xy / xx * x, xy / xx};
    };
    const Line all = without(parts);
    double squares = 0.0, scatter = 0.0;
    for (std::size_t part = 0; part < parts; ++part)
        squares += std::pow(without(part).slope - all.slope, 2);
    for (const Pixel& p : near) scatter += std::pow(p.y - all.y(p.x), 2);
    const double eighths = static_cast<double>(parts);
    double error = std::sqrt(squares * (eighths - 1.0) / eighths);
    scatter = std::sqrt(scatter / static_cast<double>(near.size() - 2));

    // Two pieces of ground at different levels (one of them a shadow) show in the slope of each: it is not that of the line through both.
    double xx = 0.0, xy = 0.0;
    for (const bool left : {true, false}) {
        double n = 0.0, x = 0.0, y = 0.0;
        const auto each = [&](auto use) {
            for (const Pixel& p : near)
                if ((p.x < middle) == left) use(p);
        };
        each([&](const Pixel& p) { n += 1.0, x += p.x, y += p.y; });
        if (n == 0.0) continue;
        x /= n, y /= n;
        each([&](const Pixel& p) { xx += (p.x - x) * (p.x - x), xy += (p.x - x) * (p.y - y); });
    }
    const double apart = std::abs(xy / xx - all.slope),
                 by_chance = 2.0 * std::max(scatter, 0.1) * std::sqrt(8.0 / xx);
    if (apart > by_chance) error = std::max(error, apart);
    return Slope{all.level, all.slope, error, scatter};
}

}  // namespace

std::optional<BaseLine> find_base_line(const std::vector<Pixel>& edge, std::size_t width) {
    if (edge.size() < 16) return std::nullopt;
    const double tolerance = std::max(1.5, 0.002 * static_cast<double>(width));
    const double middle = 0.5 * (edge.front().x + edge.back().x);
    const std::size_t step = std::max<std::size_t>(1, edge.size() / 150);

    // === The line of a pair that most points lie on
    const std::size_t least = std::max<std::size_t>(8, width / 50);
    // A shadow may hang under the base line by a third of the points; under a line over the heap hangs nearly all of it.
    const auto too_high = [&](const Support& s, std::size_t count) { return 3 * s.under > count; };
    Line best{0.0, 0.0};
    double most = 0.0;
    for (std::size_t a = 0; a < edge.size() && edge[a].x < middle; a += step)
        for (std::size_t b = edge.size() - 1; b > a && edge[b].x > middle; b -= std::min(b, step)) {
            const double slope = (edge[b].y - edge[a].y) / (edge[b].x - edge[a].x);
            if (std::abs(slope) > steepest) continue;
            const Line line{edge[a].y - slope * edge[a].x, slope};
            const Support s = support(line, edge, step, tolerance, middle);
            if (step * std::min(s.left, s.right) < least / 2 || too_high(s, edge.size() / step))
                continue;
            if (s.score > most) most = s.score, best = line;
        }
    if (most == 0.0) return std::nullopt;

    // === Least squares through what lies on it
    std::optional<Slope> fit;
    for (int round = 0; round < 5; ++round) {
        fit = fitted(best, edge, tolerance, middle);
        if (!fit) return std::nullopt;
        best = {fit->level, fit->slope};
    }
    const Support s = support(best, edge, 1, tolerance, middle);
    if (s.left < least || s.right < least || too_high(s, edge.size())) return std::nullopt;
    // Neighbouring columns share their noise (JPEG works in blocks of eight); no edge is better than a tenth of a pixel.
    const double effective = static_cast<double>(s.left + s.right) / 8.0;
    const double across = edge.back().x - edge.front().x;
    return BaseLine{best, std::max(fit->slope_error, 0.1 / across),
                    std::max(fit->scatter, 0.1) / std::sqrt(effective)};
}

}  // namespace photo
