// SPDX-License-Identifier: MIT
#include "calibrate/profile_target.hpp"

#include "cases/messages.hpp"
#include "scaling/errors.hpp"
#include "statistics/intervals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace calibrate {
namespace {

constexpr std::array<double, 4> ring_edges = {0.125, 0.375, 0.625, 0.875};  // of the base's radius
constexpr std::array ring_names = {"height_near_axis", "height_half_way", "height_near_edge"};
constexpr double millimetre = 1e-3;                // m
constexpr double sector = std::numbers::pi / 6.0;  // rad

struct Reading {
    double azimuth, r, z;
};

std::vector<Reading> last_scan(const cases::Recording& recording) {
    std::vector<Reading> all;
    if (!recording.has("r") || !recording.has("z")) return all;
    const std::vector<double>&azimuth = recording.values("azimuth"), &r = recording.values("r"),
          &z = recording.values("z");
    const bool timed = recording.has("t");
    double last = -HUGE_VAL;
    for (std::size_t k = 0; k < z.size(); ++k) {
        if (!std::isfinite(azimuth[k] + r[k] + z[k])) continue;
        const double t = timed ? recording.values("t")[k] : 0.0;
        if (t > last) all.clear(), last = t;
        if (t == last) all.push_back({azimuth[k], std::abs(r[k]), z[k]});
    }
    return all;
}

// Sample standard deviation, over sectors, of the readings less their least squares line over r; nothing for one sector.
std::optional<double> between_sectors(const std::vector<Reading>& readings) {
    double r0 = 0.0, z0 = 0.0, rr = 0.0, rz = 0.0;
    const auto count = static_cast<double>(readings.size());
    for (const Reading& p : readings) r0 += p.r / count, z0 += p.z / count;
    for (const Reading& p : readings) rr += (p.r - r0) * (p.r - r0), rz += (p.r - r0) * (p.z - z0);
    const double slope = rr > 0.0 ? rz / rr : 0.0;
    std::map<int, std::pair<double, int>> sums;
    for (const Reading& p : readings) {
        auto& [sum, number] = sums[static_cast<int>(std::floor(p.azimuth / sector))];
        sum += p.z - z0 - slope * (p.r - r0), ++number;
    }
    std::vector<double> means;
    for (const auto& [where, sum] : sums) means.push_back(sum.first / sum.second);
    if (means.size() < 2) return std::nullopt;
    return statistics::summary(means).standard_deviation;
}

std::size_t sectors(const std::vector<Reading>& readings) {
    std::map<int, int> seen;
    for (const Reading& p : readings) ++seen[static_cast<int>(std::floor(p.azimuth / sector))];
    return seen.size();
}

double deviation(const cases::Case& c, const cases::Experiment& e,
                 const std::vector<Reading>& readings) {
    double one = between_sectors(readings).value_or(0.0);
    if (const auto noise = e.noise.find("z"); noise != e.noise.end())
        one = std::max(one, noise->second);
    if (!(one > 0.0))
        throw scaling::InvalidInput(
            scaling::mistake(c.path + ": experiments " + cases::in_quotes(e.id) + ".noise",
                             "no deviation of the heights", "must be > 0",
                             "scan several azimuths, or state \"noise\": {\"z\": \"0.5 mm\"}"));
    return one / std::sqrt(static_cast<double>(sectors(readings)));
}

}  // namespace

std::vector<RingHeight> ring_heights(const cases::Case& c, const cases::Experiment& e) {
    std::vector<RingHeight> rings;
    if (!e.recording) return rings;
    const std::vector<Reading> all = last_scan(*e.recording);
    const double base_radius =
        0.5 * e.conditions.at("base_diameter").quantity<scaling::Length>().value();
    for (std::size_t k = 0; k + 1 < ring_edges.size(); ++k) {
        std::vector<Reading> readings;
        for (const Reading& p : all)
            if (p.r >= ring_edges[k] * base_radius && p.r < ring_edges[k + 1] * base_radius)
                readings.push_back(p);
        if (readings.empty()) continue;
        RingHeight ring{};
        double height = 0.0;
        for (const Reading& p : readings)
            ring.r.push_back(p.r), height += p.z / static_cast<double>(readings.size());
        ring.target = {ring_names[k], "mm", height / millimetre,
                       deviation(c, e, readings) / millimetre};
        rings.push_back(std::move(ring));
    }
    return rings;
}

std::optional<double> height_in(const RingHeight& ring, const std::vector<double>& r,
                                const std::vector<double>& z) {
    if (r.empty()) return std::nullopt;
    double sum = 0.0;
    for (const double at : ring.r) {
        const auto above = std::lower_bound(r.begin(), r.end(), at);
        const auto k = static_cast<std::size_t>(above - r.begin());
        if (k == 0 || k == r.size()) {
            sum += k == 0 ? z.front() : z.back();
            continue;
        }
        const double share = (at - r[k - 1]) / (r[k] - r[k - 1]);
        sum += z[k - 1] + share * (z[k] - z[k - 1]);
    }
    return sum / static_cast<double>(ring.r.size()) / millimetre;
}

}  // namespace calibrate
