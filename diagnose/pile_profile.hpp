// SPDX-License-Identifier: MIT
// What is compared of a heap: its scan, reduced ring by ring, recording and simulation alike. In each ring about the base's axis
// least squares give
//   z(azimuth, r) = z0 + zc cos(azimuth) + zs sin(azimuth) + slope (r - mean r)
// z0 is the profile, zc and zs its lean to one side, and the root mean square of what is left the roughness of the surface.
#pragma once

#include "cases/case.hpp"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace diagnose {

struct Scan {
    std::vector<double> azimuth, r, z;  // rad, m, m; finite
};

bool is_profile(const cases::Experiment&);  // a pile with a scan

// Of several instants `t` the last. Empty where the recording is no profile.
Scan scan_of(const cases::Recording&);

class Rings {
  public:
    // Rings d wide or R/6, whichever is wider; those with 3 spots or more. `noise`: of z, m; where it is not known (0) the
    // roughness is left out, which it is part of.
    Rings(const Scan& spots, double base_radius, double d, double noise);

    // "z", "z_cos", "z_sin", "z_roughness"
    static const std::array<std::string, 4>& channels();
    std::size_t count() const { return rings_.size(); }
    const std::vector<double>& radius() const { return radius_; }  // m, mean of the spots

    // [4 rings], channel by channel. NaN what the spots of a ring do not tell. Heights without noise of the instrument are given
    // the roughness that it adds.
    Eigen::VectorXd reduced(const std::vector<double>& z, bool with_noise) const;
    // Covariance of the same by the noise of the instrument, each spot's its own.
    Eigen::MatrixXd instrument() const;
    bool operator==(const Rings&) const = default;

  private:
    struct Ring {
        std::vector<std::size_t> spots;
        Eigen::MatrixXd basis, solve;  // [spots][3 or 1 and slope], its pseudo-inverse
        bool leans = false;            // zc and zs are told
        bool operator==(const Ring&) const = default;
    };
    std::vector<Ring> rings_;
    std::vector<double> radius_;
    double noise_;
};

}  // namespace diagnose
