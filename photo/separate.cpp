// SPDX-License-Identifier: MIT
#include "photo/separate.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

namespace photo {
namespace {

struct Image {
    std::size_t width, height;
    std::vector<float> t;  // [height][width]

    double x(std::size_t i) const {
        return 2.0 * static_cast<double>(i) / static_cast<double>(width) - 1.0;
    }
    double y(std::size_t j) const {
        return 2.0 * static_cast<double>(j) / static_cast<double>(height) - 1.0;
    }
};

Image tone_of(const Picture& p, const Box& box, Tone tone) {
    Image image{box.width, box.height, std::vector<float>(box.width * box.height)};
    for (std::size_t j = 0; j < box.height; ++j)
        for (std::size_t i = 0; i < box.width; ++i) {
            const std::uint8_t* c = &p.rgb[3 * ((box.y + j) * p.width + box.x + i)];
            const float r = c[0], g = c[1], b = c[2];
            image.t[j * box.width + i] = tone == Tone::brightness
                                             ? 0.299f * r + 0.587f * g + 0.114f * b
                                         : tone == Tone::red_less_blue ? r - b
                                                                       : g - 0.5f * (r + b);
        }
    return image;
}

Image median_3x3(const Image& from) {
    Image to = from;
    for (std::size_t j = 1; j + 1 < from.height; ++j)
        for (std::size_t i = 1; i + 1 < from.width; ++i) {
            std::array<float, 9> near;
            for (std::size_t k = 0; k < 9; ++k)
                near[k] = from.t[(j + k / 3 - 1) * from.width + i + k % 3 - 1];
            std::nth_element(near.begin(), near.begin() + 4, near.end());
            to.t[j * from.width + i] = near[4];
        }
    return to;
}

// A polynomial in x and y, terms by degree: 3 of them make a plane, 10 a cubic.
constexpr Eigen::Index plane = 3, cubic = 10;
using Surface = Eigen::Matrix<double, cubic, 1>;

Surface terms(double x, double y) {
    return Surface{1.0, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y};
}

double at(const Surface& s, double x, double y) { return s.dot(terms(x, y)); }

// Every `step`-th pixel, each way.
Image thinned(const Image& image, std::size_t step) {
    Image thin{(image.width + step - 1) / step, (image.height + step - 1) / step, {}};
    for (std::size_t j = 0; j < image.height; j += step)
        for (std::size_t i = 0; i < image.width; i += step)
            thin.t.push_back(image.t[j * image.width + i]);
    return thin;
}

// Least squares over the pixels k that `wanted(k)`. A trace of ridge keeps at 0 what few pixels leave open.
template <class Wanted>
Surface fit(const Image& image, Eigen::Index count, Wanted wanted) {
    Eigen::Matrix<double, cubic, cubic> normal = Eigen::Matrix<double, cubic, cubic>::Zero();
    Surface right = Surface::Zero();
    for (std::size_t k = 0; k < image.t.size(); ++k) {
        if (!wanted(k)) continue;
        const Surface row = terms(image.x(k % image.width), image.y(k / image.width));
        normal += row * row.transpose();
        right += static_cast<double>(image.t[k]) * row;
    }
    Surface s = Surface::Zero();
    normal.diagonal().tail(cubic - 1).array() += 1e-6 * (normal(0, 0) + 1.0);
    normal(0, 0) += 1e-9;
    s.head(count) = normal.topLeftCorner(count, count).ldlt().solve(right.head(count));
    return s;
}

// Otsu: the threshold with the largest variance between the two classes; values below 0 count as 0.
double otsu(const std::vector<float>& values) {
    constexpr std::size_t bins = 512;
    const double top =
        std::max(1e-6, static_cast<double>(*std::max_element(values.begin(), values.end())));
    std::array<double, bins> count{};
    for (const float v : values) {
        const double share = std::clamp(static_cast<double>(v) / top, 0.0, 1.0);
        ++count[std::min(bins - 1, static_cast<std::size_t>(share * bins))];
    }
    double all = 0.0, moment = 0.0;
    for (std::size_t k = 0; k < bins; ++k)
        all += count[k], moment += static_cast<double>(k) * count[k];
    double below = 0.0, below_moment = 0.0, best = -1.0, threshold = top;
    for (std::size_t k = 0; k + 1 < bins; ++k) {
        below += count[k], below_moment += static_cast<double>(k) * count[k];
        if (below == 0.0 || below == all) continue;
        const double apart = below_moment / below - (moment - below_moment) / (all - below);
        const double between = below * (all - below) * apart * apart;
        if (between > best) best = between, threshold = top * (static_cast<double>(k) + 1.0) / bins;
    }
    return threshold;
}

// 1.4826 times the median of |values|: the standard deviation of normal ones.
double robust_scale(std::vector<double> values) {
    if (values.empty()) return 0.0;
    for (double& v : values) v = std::abs(v);
    const auto middle = values.begin() + static_cast<long>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return 1.4826 * *middle;
}

// The two surfaces; a contrast of 0 where there are no two.
struct Classes {
    Surface background, heap;
    double sign,
        contrast;  // +1 where the heap is lighter; mean distance of the surfaces on the heap

    // About 0 on the background, about 1 on the heap. The heap's plane is not trusted where it runs into the background's surface.
    double place(double tone, double x, double y) const {
        const double b = at(background, x, y);
        return sign * (tone - b) / std::max(sign * (at(heap, x, y) - b), 0.3 * contrast);
    }
};

Classes two_classes(const Image& image, double sign) {
    const auto x = [&](std::size_t k) { return image.x(k % image.width); };
    const auto y = [&](std::size_t k) { return image.y(k / image.width); };
    Classes c{Surface::Zero(), Surface::Zero(), sign, 0.0};

    // === First guess: what lies off the plane of the upper border
    c.background = fit(image, plane, [&](std::size_t k) {
        const std::size_t i = k % image.width, j = k / image.width, side = image.width / 20;
        return 10 * j < image.height ||
               (3 * j < image.height && (i < side || i >= image.width - side));
    });
    std::vector<float> off(image.t.size());
    for (std::size_t k = 0; k < off.size(); ++k)
        off[k] = static_cast<float>(
            sign * (static_cast<double>(image.t[k]) - at(c.background, x(k), y(k))));
    const double threshold = otsu(off);
    std::vector<char> on(off.size());
    for (std::size_t k = 0; k < on.size(); ++k) on[k] = off[k] > threshold;

    // === By turns: surfaces through the classes, classes by the nearer surface
    for (int round = 0; round < 15; ++round) {
        c.background = fit(image, cubic, [&](std::size_t k) { return !on[k]; });
        c.heap = fit(image, plane, [&](std::size_t k) { return on[k] != 0; });
        double sum = 0.0;
        std::size_t count = 0, changed = 0;
        for (std::size_t k = 0; k < on.size(); ++k)
            if (on[k])
                sum += sign * (at(c.heap, x(k), y(k)) - at(c.background, x(k), y(k))), ++count;
        c.contrast = count < 20 ? 0.0 : std::max(0.0, sum / static_cast<double>(count));
        if (c.contrast == 0.0) break;
        for (std::size_t k = 0; k < on.size(); ++k) {
            const bool heap = c.place(image.t[k], x(k), y(k)) > 0.5;
            changed += heap != (on[k] != 0), on[k] = heap;
        }
        if (changed * 1000 < on.size()) break;  // noise goes on flipping a few
    }
    return c;
}

}  // namespace

Field separate(const Picture& picture, const Box& box, Tone tone, bool lighter) {
    const Image image = median_3x3(tone_of(picture, box, tone));
    Field field{box.width, box.height, std::vector<float>(image.t.size(), 0.0f), 0.0};
    // Smooth surfaces need no more than some 200 columns.
    const Classes c = two_classes(thinned(image, std::max<std::size_t>(1, box.width / 200)),
                                  lighter ? 1.0 : -1.0);
    if (c.contrast == 0.0) return field;
    std::vector<double> about_0, about_1;
    for (std::size_t k = 0; k < image.t.size(); ++k) {
        const double v = c.place(image.t[k], image.x(k % image.width), image.y(k / image.width));
        field.v[k] = static_cast<float>(v);
        if (k % 3 == 0) (v > 0.5 ? about_1 : about_0).push_back(v > 0.5 ? v - 1.0 : v);
    }
    // One grey level is the least that an encoded picture scatters.
    const double noise =
        std::hypot(robust_scale(std::move(about_0)), robust_scale(std::move(about_1)));
    field.contrast_to_noise = 1.0 / std::max(noise, 1.0 / c.contrast);
    return field;
}

}  // namespace photo
