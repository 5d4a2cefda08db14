// SPDX-License-Identifier: MIT
#include "dem_min/clump.hpp"

#include "contact/scale_free.hpp"
#include "scaling/errors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace dem_min {
namespace {

using std::numbers::pi;

// Integrals over the union of a row of unit spheres, in units of the radius and without density: V/pi, I_3/pi, I_1/pi.
struct Integrals {
    double volume = 0.0, along = 0.0, across = 0.0;
};

Integrals integrals(int balls, double spacing) {
    const double border = std::min(1.0, 0.5 * spacing);
    Integrals sum;
    for (int k = 0; k < balls; ++k) {
        const double z = (k - 0.5 * (balls - 1)) * spacing;  // m, of the sphere's centre
        const double from = k == 0 ? -1.0 : -border, to = k + 1 == balls ? 1.0 : border;
        const auto between = [&](auto&& primitive) { return primitive(to) - primitive(from); };
        const double square = between([](double u) { return u - u * u * u / 3.0; });
        const double fourth = between([](double u) {
            const double u3 = u * u * u;
            return u - 2.0 / 3.0 * u3 + u3 * u * u / 5.0;
        });
        // rho^2 (z + u)^2
        const double moment = between([&](double u) {
            const double u2 = u * u;
            return z * z * (u - u2 * u / 3.0) + 2.0 * z * (u2 / 2.0 - u2 * u2 / 4.0) +
                   u2 * u / 3.0 - u2 * u2 * u / 5.0;
        });
        sum.volume += square;
        sum.along += 0.5 * fourth;
        sum.across += 0.25 * fourth + moment;
    }
    return sum;
}

void require(bool right, const std::string& what, double value, const std::string& rule) {
    if (right && std::isfinite(value)) return;
    throw scaling::InvalidParameter(
        scaling::mistake("clump." + what, std::to_string(value), rule, "give one in SI units"));
}

Clump row(int balls, double radius, double spacing, double mass, const Integrals& in) {
    Clump clump;
    for (int k = 0; k < balls; ++k)
        clump.balls.push_back({{0.0, 0.0, (k - 0.5 * (balls - 1)) * spacing}, radius});
    clump.mass = mass;
    const double unit = mass * (radius * radius);
    const double across = unit * (in.across / in.volume);
    clump.inertia = {across, across, unit * (in.along / in.volume)};
    return clump;
}

}  // namespace

Clump row_of_spheres(int balls, double radius, double spacing, double density) {
    require(balls >= 1, "balls", balls, "must be >= 1");
    require(radius > 0.0, "radius", radius, "must be > 0");
    require(spacing >= 0.0, "spacing", spacing, "must be >= 0");
    require(density > 0.0, "density", density, "must be > 0");
    const Integrals in = integrals(balls, spacing / radius);
    return row(balls, radius, spacing, density * pi * in.volume * (radius * radius * radius), in);
}

Clump elongated_grain(double d, double aspect_ratio, double density) {
    require(d > 0.0, "diameter", d, "must be > 0");
    require(aspect_ratio >= 1.0, "aspect_ratio", aspect_ratio, "must be >= 1");
    require(density > 0.0, "density", density, "must be > 0");
    const double span = 2.0 * (aspect_ratio - 1.0);  // in radii, between the outer centres
    const int balls = 1 + static_cast<int>(std::ceil(span));
    const double spacing = balls == 1 ? 0.0 : span / (balls - 1);
    const Integrals in = integrals(balls, spacing);
    const double r = 0.5 * d, radius = r * contact::cube_root(4.0 / 3.0 / in.volume);
    const double mass = density * (4.0 / 3.0 * pi) * (r * r * r);  // as Particles::add has it
    return row(balls, radius, radius * spacing, mass, in);
}

double half_length(const Clump& row) { return row.balls.back().place.z + row.balls.back().radius; }

}  // namespace dem_min
