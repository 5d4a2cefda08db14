// SPDX-License-Identifier: MIT
#include "dem_min/timestep.hpp"

#include "contact/jkr.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace dem_min {

double StepLimits::shortest() const {
    return std::min({rayleigh, hertz, adhesive_gap, bridge_gap});
}

double rayleigh_time(double radius, double density, double shear_modulus, double poisson_ratio) {
    return std::numbers::pi * radius * std::sqrt(density / shear_modulus) /
           (0.1631 * poisson_ratio + 0.8766);
}

StepLimits step_limits(const StepInput& in) {
    const double shear_modulus = in.youngs_modulus / (2.0 * (1.0 + in.poisson_ratio));
    const double e_star = in.youngs_modulus / (2.0 * (1.0 - in.poisson_ratio * in.poisson_ratio));
    const double r_star = 0.5 * in.radius;
    const double m_star =
        0.5 * in.density * 4.0 / 3.0 * std::numbers::pi * in.radius * in.radius * in.radius;
    const double collision =
        2.87 * std::pow(m_star * m_star / (r_star * e_star * e_star * in.fastest_impact), 0.2);
    const auto fifth_of = [&](double gap, double work) {  // at the speed that the work stops
        return gap / (5.0 * std::sqrt(2.0 * work / m_star));
    };
    double adhesive = std::numeric_limits<double>::infinity(), bridge = adhesive;
    if (in.work_of_adhesion > 0.0) {
        const contact::Jkr law{.e_star = e_star, .w = in.work_of_adhesion};
        const double scale = law.length_scale(r_star);
        const double gap = law.tear_off_overlap(r_star, scale);
        adhesive = fifth_of(-gap, law.energy(r_star, scale, gap));
    }
    if (in.bridge.acts())
        bridge = fifth_of(in.bridge.rupture_gap, in.bridge.work(r_star, in.bridge.rupture_gap));
    return {0.2 * rayleigh_time(in.radius, in.density, shear_modulus, in.poisson_ratio),
            collision / 20.0, adhesive, bridge};
}

}  // namespace dem_min
