// SPDX-License-Identifier: MIT
#include "photo/outline.hpp"

#include <algorithm>
#include <cmath>

namespace photo {
namespace {

// Mean over 3 x 3, twice: the region's shape, not its edge, is read from this.
std::vector<float> smoothed(const Field& f) {
    std::vector<float> from = f.v, to = f.v;
    for (int round = 0; round < 2; ++round) {
        for (std::size_t j = 1; j + 1 < f.height; ++j)
            for (std::size_t i = 1; i + 1 < f.width; ++i) {
                float sum = 0.0f;
                for (std::size_t k = 0; k < 9; ++k)
                    sum += from[(j + k / 3 - 1) * f.width + i + k % 3 - 1];
                to[j * f.width + i] = sum / 9.0f;
            }
        from = to;
    }
    return to;
}

struct Component {
    std::vector<std::size_t> pixels;
    bool on_line = false;
};

// Pixels that are connected with `start`; takes them out of `left`.
Component grown(std::vector<char>& left, std::size_t start, std::size_t width,
                const std::optional<Line>& line) {
    Component c;
    c.pixels.push_back(start);
    left[start] = 0;
    for (std::size_t next = 0; next < c.pixels.size(); ++next) {
        const std::size_t k = c.pixels[next], i = k % width;
        const double y = static_cast<double>(k / width);
        if (!line || y >= line->y(static_cast<double>(i)) - 3.0) c.on_line = true;
        const auto visit = [&](std::size_t n) {
            if (left[n]) left[n] = 0, c.pixels.push_back(n);
        };
        if (i > 0) visit(k - 1);
        if (i + 1 < width) visit(k + 1);
        if (k >= width) visit(k - width);
        if (k + width < left.size()) visit(k + width);
    }
    return c;
}

// The field along one column, smoothed by 1 2 1 and counted from the background's side: `down` for the upper edge.
struct Ray {
    const Field& field;
    std::size_t column;
    bool down;

    double length() const { return static_cast<double>(field.height); }
    double raw(long k) const {
        const long last = static_cast<long>(field.height) - 1;
        const long at = std::clamp(k, 0L, last), row = down ? at : last - at;
        return static_cast<double>(field.v[static_cast<std::size_t>(row) * field.width + column]);
    }
    double operator()(long k) const { return 0.25 * raw(k - 1) + 0.5 * raw(k) + 0.25 * raw(k + 1); }

    double mean(long from, long to) const {
        double sum = 0.0;
        for (long k = from; k < to; ++k) sum += raw(k);
        return sum / static_cast<double>(to - from);
    }
};

// The crossing of `share` between the levels on both sides that is nearest to `coarse`.
std::optional<double> crossing(const Ray& ray, long coarse, double share) {
    constexpr long near = 4, far = 10;
    double outside = ray.mean(coarse - far, coarse - near + 1),
           inside = ray.mean(coarse + near, coarse + far + 1);
    // Where the heap is thinner than that, the surfaces' own levels have to do.
    if (inside - outside < 0.3) outside = 0.0, inside = 1.0;
    const double level = outside + share * (inside - outside);
    std::optional<double> best;
    for (long k = coarse - near; k < coarse + near; ++k) {
        const double a = ray(k), b = ray(k + 1);
        if (!(a < level && b >= level)) continue;
        const double y = static_cast<double>(k) + (level - a) / (b - a);
        const double from_coarse = std::abs(y - static_cast<double>(coarse));
        if (!best || from_coarse < std::abs(*best - static_cast<double>(coarse))) best = y;
    }
    return best;
}

std::vector<Pixel> edge(const Field& f, const Region& r, bool upper, double share) {
    std::vector<Pixel> points;
    for (std::size_t i = 0; i < r.width; ++i) {
        long first = -1;
        for (std::size_t k = 0; k < r.height && first < 0; ++k) {
            const std::size_t row = upper ? k : r.height - 1 - k;
            if (r.on[row * r.width + i]) first = static_cast<long>(k);
        }
        if (first < 0) continue;
        if (const auto at = crossing(Ray{f, i, upper}, first, share)) {
            const double y = upper ? *at : static_cast<double>(r.height) - 1.0 - *at;
            points.push_back({static_cast<double>(i), y});
        }
    }
    return points;
}

}  // namespace

Region largest_region(const Field& f, const std::optional<Line>& above) {
    Region r{f.width, f.height, 0,     std::vector<char>(f.width * f.height),
             false,   false,    false, false};
    const std::vector<float> v = smoothed(f);
    std::vector<char> left(v.size());
    for (std::size_t k = 0; k < v.size(); ++k) {
        const double x = static_cast<double>(k % f.width), y = static_cast<double>(k / f.width);
        left[k] = v[k] > 0.5f && (!above || y < above->y(x));
    }
    Component best;
    for (std::size_t k = 0; k < left.size(); ++k) {
        if (!left[k]) continue;
        Component c = grown(left, k, f.width, above);
        if (c.on_line && c.pixels.size() > best.pixels.size()) best = std::move(c);
    }
    r.pixels = best.pixels.size();
    for (const std::size_t k : best.pixels) {
        r.on[k] = 1;
        const std::size_t i = k % f.width, j = k / f.width;
        r.touches_left |= i == 0, r.touches_right |= i + 1 == f.width;
        r.touches_top |= j == 0, r.touches_bottom |= j + 1 == f.height;
    }
    return r;
}

std::vector<Pixel> upper_edge(const Field& f, const Region& r, double share) {
    return edge(f, r, true, share);
}

std::vector<Pixel> lower_edge(const Field& f, const Region& r) { return edge(f, r, false, 0.5); }

}  // namespace photo
