// SPDX-License-Identifier: MIT
#include "rigs/angle_of_repose.hpp"

#include "scaling/errors.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace rigs {
namespace {

using std::numbers::pi;

constexpr std::size_t sectors = 12;
constexpr std::size_t fewest_samples = 6;

struct Spot {
    double x, y, z, area;  // m, m, m, m^2
};

// Spots nearer to the axis than `reach`.
std::vector<Spot> spots_of(const HeightMap& map, double reach) {
    std::vector<Spot> spots;
    spots.reserve(map.z.size());
    for (std::size_t k = 0; k < map.azimuths; ++k) {
        const double c = std::cos(map.azimuth(k)), s = std::sin(map.azimuth(k));
        for (std::size_t i = 0; i < map.rings; ++i) {
            const double r = map.radius(i);
            if (r >= reach) break;
            spots.push_back({r * c, r * s, map.z[k * map.rings + i], map.area(i)});
        }
    }
    return spots;
}

// Sector of an azimuth in (-pi, pi].
std::size_t sector_of(double x, double y) {
    const double turns = std::atan2(y, x) / (2.0 * pi) + 0.5;
    return std::min(sectors - 1, static_cast<std::size_t>(turns * static_cast<double>(sectors)));
}

// Within one diameter of the rim grains have no neighbour outside: the scanner sees their sides and the gaps between them.
double flank_reach(const HeightMap& map) { return map.base_radius - map.grain_diameter; }

struct FlankPoint {
    double r, z, weight;  // m from the apex, m, any unit
};

struct Line {
    double level, slope;  // z = level - slope r
};

// Weighted least squares; nothing for fewer than three points or points at one distance.
std::optional<Line> line_through(std::span<const FlankPoint> points) {
    double w = 0.0, r = 0.0, z = 0.0;
    for (const FlankPoint& p : points) w += p.weight, r += p.weight * p.r, z += p.weight * p.z;
    if (points.size() < 3 || !(w > 0.0)) return std::nullopt;
    r /= w, z /= w;
    double rr = 0.0, rz = 0.0;
    for (const FlankPoint& p : points) {
        rr += p.weight * (p.r - r) * (p.r - r);
        rz += p.weight * (p.r - r) * (p.z - z);
    }
    if (!(rr > 0.0)) return std::nullopt;
    const double slope = -rz / rr;
    return Line{z + slope * r, slope};
}

// The line through the points between `low` and `high`. Points are chosen by the heights that the line itself has where
// they stand, again and again until the choice stays; to choose by their own heights, which scatter, would flatten the line.
std::optional<Line> flank_line(std::span<const FlankPoint> points, double low, double high) {
    std::vector<FlankPoint> chosen;
    for (const FlankPoint& p : points) {
        if (p.z >= low && p.z <= high) chosen.push_back(p);
    }
    std::optional<Line> line = line_through(chosen);
    for (int round = 0; round < 20 && line; ++round) {
        const std::size_t before = chosen.size();
        chosen.clear();
        for (const FlankPoint& p : points) {
            const double z = line->level - line->slope * p.r;
            if (z >= low && z <= high) chosen.push_back(p);
        }
        const double slope = line->slope;
        line = line_through(chosen);
        if (line && chosen.size() == before && line->slope == slope) break;
    }
    return line;
}

// Mean and sample deviation of the angles; nothing for fewer than half of the sectors.
std::optional<Angle> mean_of(const std::vector<double>& angles) {
    if (angles.size() < fewest_samples) return std::nullopt;
    const double n = static_cast<double>(angles.size());
    double mean = 0.0, squares = 0.0;
    for (const double a : angles) mean += a / n;
    for (const double a : angles) squares += (a - mean) * (a - mean);
    return Angle{mean, std::sqrt(squares / (n - 1.0)), angles.size()};
}

std::optional<Angle> flank(const HeightMap& map) {
    const double h = height(map);
    const Point top = apex(map);
    std::vector<std::vector<FlankPoint>> points(sectors);
    for (const Spot& s : spots_of(map, flank_reach(map))) {
        const double x = s.x - top.x, y = s.y - top.y;
        points[sector_of(x, y)].push_back({std::hypot(x, y), s.z, 1.0});
    }
    std::vector<double> angles;
    for (const auto& sector : points) {
        if (const auto line = flank_line(sector, 0.2 * h, 0.8 * h)) {
            angles.push_back(std::atan(line->slope));
        }
    }
    return mean_of(angles);
}

std::optional<Angle> silhouette(const HeightMap& map) {
    constexpr std::size_t views = 12;
    const double h = height(map), bin = 2.0 * map.base_radius / static_cast<double>(map.rings);
    const Point top = apex(map);
    const std::vector<Spot> spots = spots_of(map, map.base_radius);
    std::vector<double> angles;
    for (std::size_t view = 0; view < views; ++view) {
        const double azimuth = pi * static_cast<double>(view) / static_cast<double>(views);
        const double c = std::cos(azimuth), s = std::sin(azimuth);
        const double axis = c * top.x + s * top.y;
        // The outline left (0) and right (1) of the apex: highest spot in each strip of width `bin`.
        std::array<std::vector<FlankPoint>, 2> side;
        for (std::size_t half = 0; half < 2; ++half) {
            const double reach = flank_reach(map) + (half == 0 ? axis : -axis);
            for (std::size_t b = 0; (static_cast<double>(b) + 1.0) * bin <= reach; ++b) {
                side[half].push_back({(static_cast<double>(b) + 0.5) * bin, 0.0, 1.0});
            }
        }
        for (const Spot& p : spots) {
            const double u = c * p.x + s * p.y - axis;
            std::vector<FlankPoint>& outline = side[u < 0.0 ? 0 : 1];
            const auto b = static_cast<std::size_t>(std::abs(u) / bin);
            if (b < outline.size()) outline[b].z = std::max(outline[b].z, p.z);
        }
        const auto left = flank_line(side[0], 0.2 * h, 0.8 * h);
        const auto right = flank_line(side[1], 0.2 * h, 0.8 * h);
        if (left && right) {
            angles.push_back(0.5 * (std::atan(left->slope) + std::atan(right->slope)));
        }
    }
    return mean_of(angles);
}

struct Cone {
    double x, y, h, slope;  // z = h - slope |(x, y) - apex|
    double scale;           // m, robust spread of the spots about it
};

double tukey_weight(double residual, double scale) {
    const double u = residual / (4.685 * scale);
    return std::abs(u) < 1.0 ? (1.0 - u * u) * (1.0 - u * u) : 0.0;
}

bool in_window(const Cone& cone, double distance) {
    const double z = cone.h - cone.slope * distance;
    return z >= 0.1 * cone.h && z <= 0.9 * cone.h;
}

// 1.4826 times the median of |residuals|: the standard deviation of normal ones.
double robust_scale(std::vector<double> residuals) {
    for (double& e : residuals) e = std::abs(e);
    const auto middle = residuals.begin() + static_cast<long>(residuals.size() / 2);
    std::nth_element(residuals.begin(), middle, residuals.end());
    return 1.4826 * *middle;
}

// One step of Gauss and Newton with Tukey's weights. Linear in h, slope and slope times the apex's shift, as
// |x - x0 - shift| = |x - x0| - u . shift with u the unit vector from the apex.
bool improve(Cone& cone, const std::vector<Spot>& spots, double longest_shift) {
    std::vector<double> residuals;
    for (const Spot& p : spots) {
        const double r = std::hypot(p.x - cone.x, p.y - cone.y);
        if (in_window(cone, r)) residuals.push_back(p.z - cone.h + cone.slope * r);
    }
    if (residuals.size() < 12) return false;
    // Not below rounding: on an exact cone all weights are then 1.
    cone.scale = std::max(robust_scale(std::move(residuals)), 1e-9 * cone.h);
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (const Spot& p : spots) {
        const double r = std::hypot(p.x - cone.x, p.y - cone.y);
        if (!in_window(cone, r) || r == 0.0) continue;
        const double w = p.area * tukey_weight(p.z - cone.h + cone.slope * r, cone.scale);
        const Eigen::Vector4d row(1.0, -r, (p.x - cone.x) / r, (p.y - cone.y) / r);
        normal += w * row * row.transpose();
        right += w * p.z * row;
    }
    const Eigen::Vector4d fit = normal.fullPivLu().solve(right);
    if (!fit.allFinite() || !(fit[0] > 0.0) || !(fit[1] > 0.0)) return false;
    cone.h = fit[0], cone.slope = fit[1];
    const double shift = std::hypot(fit[2], fit[3]) / fit[1];
    const double step = shift > longest_shift ? longest_shift / shift : 1.0;
    cone.x += step * fit[2] / fit[1], cone.y += step * fit[3] / fit[1];
    return true;
}

std::optional<Cone> fit_cone(const HeightMap& map, const std::vector<Spot>& spots) {
    const double foot = foot_radius(map), h = height(map);
    if (!(foot > 0.0)) return std::nullopt;
    const Point top = apex(map);
    Cone cone{top.x, top.y, h, h / foot, 0.0};
    for (int round = 0; round < 60; ++round) {
        const Cone last = cone;
        if (!improve(cone, spots, 0.1 * map.base_radius)) return std::nullopt;
        if (std::hypot(cone.x, cone.y) > map.base_radius) return std::nullopt;
        if (std::abs(cone.slope - last.slope) < 1e-9 * cone.slope) break;
    }
    return cone;
}

std::optional<Angle> cone_angle(const HeightMap& map) {
    const std::vector<Spot> spots = spots_of(map, flank_reach(map));
    const std::optional<Cone> cone = fit_cone(map, spots);
    if (!cone) return std::nullopt;
    std::vector<std::vector<FlankPoint>> points(sectors);
    for (const Spot& p : spots) {
        const double x = p.x - cone->x, y = p.y - cone->y, r = std::hypot(x, y);
        if (!in_window(*cone, r)) continue;
        const double weight = tukey_weight(p.z - cone->h + cone->slope * r, cone->scale);
        points[sector_of(x, y)].push_back({r, p.z, p.area * weight});
    }
    std::vector<double> angles;
    for (const auto& sector : points) {
        if (const auto line = line_through(sector)) angles.push_back(std::atan(line->slope));
    }
    std::optional<Angle> angle = mean_of(angles);
    if (angle) angle->angle = std::atan(cone->slope);
    return angle;
}

struct Sector {
    double covered;  // m^2 under grains
    double volume;   // m^3
    double height;   // m, highest spot
};

std::vector<Sector> sector_totals(const HeightMap& map) {
    std::vector<Sector> totals(sectors, Sector{0.0, 0.0, 0.0});
    for (std::size_t k = 0; k < map.azimuths; ++k) {
        Sector& s = totals[k * sectors / map.azimuths];
        for (std::size_t i = 0; i < map.rings; ++i) {
            const double z = map.z[k * map.rings + i];
            s.covered += z > 0.0 ? map.area(i) : 0.0;
            s.volume += z * map.area(i);
            s.height = std::max(s.height, z);
        }
    }
    return totals;
}

double radius_of(double covered, const HeightMap& map) {
    const double r = std::sqrt(covered / pi);
    return map.base_radius - r <= map.grain_diameter ? map.base_radius : r;
}

// tan(angle) = rise(sector or whole) / foot radius, whole and by sectors.
template <class Tangent>
std::optional<Angle> by_totals(const HeightMap& map, Tangent tangent) {
    Sector whole{0.0, 0.0, height(map)};
    std::vector<double> angles;
    for (const Sector& s : sector_totals(map)) {
        whole.covered += s.covered, whole.volume += s.volume;
        const double n = static_cast<double>(sectors), foot = radius_of(n * s.covered, map);
        if (s.covered > 0.0) angles.push_back(std::atan(tangent(whole.height, n * s.volume, foot)));
    }
    std::optional<Angle> angle = mean_of(angles);
    if (angle) {
        const double foot = radius_of(whole.covered, map);
        angle->angle = std::atan(tangent(whole.height, whole.volume, foot));
    }
    return angle;
}

}  // namespace

const char* to_string(Estimator estimator) {
    switch (estimator) {
        case Estimator::flank_20_80:
            return "flank_20_80";
        case Estimator::cone:
            return "cone";
        case Estimator::two_h_over_d:
            return "two_h_over_d";
        case Estimator::silhouette:
            return "silhouette";
        case Estimator::volume:
            return "volume";
        case Estimator::protractor:
            return "protractor";
    }
    return "";
}

std::optional<Estimator> estimator_named(std::string_view name) {
    for (const Estimator e : computed_estimators) {
        if (name == to_string(e)) return e;
    }
    if (name == to_string(Estimator::protractor)) return Estimator::protractor;
    return std::nullopt;
}

std::optional<Angle> angle_of_repose(const HeightMap& map, Estimator estimator) {
    if (estimator != Estimator::protractor && !(height(map) > 0.0)) return std::nullopt;
    switch (estimator) {
        case Estimator::flank_20_80:
            return flank(map);
        case Estimator::cone:
            return cone_angle(map);
        case Estimator::silhouette:
            return silhouette(map);
        case Estimator::two_h_over_d:
            return by_totals(map, [](double h, double, double foot) { return h / foot; });
        case Estimator::volume:
            return by_totals(map, [](double, double v, double foot) {
                return 3.0 * v / (pi * foot * foot * foot);
            });
        case Estimator::protractor:
            break;
    }
    throw scaling::InvalidParameter(
        scaling::mistake("angle_of_repose.estimator", "protractor", "must be one that is computed",
                         "compare a protractor's reading with silhouette"));
}

Point apex(const HeightMap& map) {
    const double level = 0.8 * height(map);
    double area = 0.0, x = 0.0, y = 0.0;
    if (!(level > 0.0)) return {0.0, 0.0};
    for (const Spot& s : spots_of(map, map.base_radius)) {
        if (s.z < level) continue;
        area += s.area, x += s.area * s.x, y += s.area * s.y;
    }
    return {x / area, y / area};
}

double foot_radius(const HeightMap& map) {
    double covered = 0.0;
    for (const Sector& s : sector_totals(map)) covered += s.covered;
    return covered > 0.0 ? radius_of(covered, map) : 0.0;
}

}  // namespace rigs
