// SPDX-License-Identifier: MIT
#include "diagnose/pile_profile.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace diagnose {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr std::size_t fewest_spots = 3;
constexpr std::size_t enough_for_roughness = 12;
constexpr double well_spread =
    0.15;  // least singular value over the largest, from which a lean is told

}  // namespace

bool is_profile(const cases::Experiment& e) {
    return e.rig == "pile" && e.recording && e.recording->has("r");
}

Scan scan_of(const cases::Recording& recording) {
    Scan scan;
    if (!recording.has("r") || !recording.has("z") || !recording.has("azimuth")) return scan;
    const std::vector<double>&azimuth = recording.values("azimuth"), &r = recording.values("r"),
          &z = recording.values("z");
    double last = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < z.size(); ++k) {
        if (!std::isfinite(azimuth[k] + r[k] + z[k])) continue;
        const double t = recording.has("t") ? recording.values("t")[k] : 0.0;
        if (t > last) scan = {}, last = t;
        if (t != last) continue;
        scan.azimuth.push_back(azimuth[k] + (r[k] < 0.0 ? std::numbers::pi : 0.0));
        scan.r.push_back(std::abs(r[k]));
        scan.z.push_back(z[k]);
    }
    return scan;
}

const std::array<std::string, 4>& Rings::channels() {
    static const std::array<std::string, 4> names{"z", "z_cos", "z_sin", "z_roughness"};
    return names;
}

Rings::Rings(const Scan& s, double base_radius, double d, double noise) : noise_(noise) {
    const double width = std::max(d, base_radius / 6.0);
    const auto count = static_cast<std::size_t>(std::max(1.0, std::floor(base_radius / width)));
    std::vector<Ring> all(count);
    for (std::size_t k = 0; k < s.r.size(); ++k) {
        const double at = s.r[k] / base_radius * static_cast<double>(count);
        if (at < static_cast<double>(count)) all[static_cast<std::size_t>(at)].spots.push_back(k);
    }
    for (Ring& ring : all) {
        if (ring.spots.size() < fewest_spots) continue;
        const auto n = static_cast<Index>(ring.spots.size());
        double mean = 0.0, most = 0.0;
        for (const std::size_t k : ring.spots) mean += s.r[k] / static_cast<double>(n);
        for (const std::size_t k : ring.spots) most = std::max(most, std::abs(s.r[k] - mean));
        MatrixXd full(n, 4);
        for (Index k = 0; k < n; ++k) {
            const std::size_t at = ring.spots[static_cast<std::size_t>(k)];
            full.row(k) << 1.0, most > 0.0 ? (s.r[at] - mean) / most : 0.0, std::cos(s.azimuth[at]),
                std::sin(s.azimuth[at]);
        }
        const auto least_of = [](const MatrixXd& m) {
            const Eigen::SelfAdjointEigenSolver<MatrixXd> squares(m.transpose() * m);
            return std::sqrt(std::max(0.0, squares.eigenvalues().minCoeff()) /
                             squares.eigenvalues().maxCoeff());
        };
        MatrixXd leaning(n, 3);
        leaning << full.col(0), full.col(2), full.col(3);
        ring.leans = n > 6 && least_of(leaning) > well_spread;
        const bool sloped = most > 1e-6 * base_radius && n > 2;
        std::vector<Index> columns{0};
        if (sloped) columns.push_back(1);
        if (ring.leans) columns.insert(columns.end(), {2, 3});
        ring.basis.resize(n, static_cast<Index>(columns.size()));
        for (std::size_t k = 0; k < columns.size(); ++k)
            ring.basis.col(static_cast<Index>(k)) = full.col(columns[k]);
        ring.solve =
            (ring.basis.transpose() * ring.basis).ldlt().solve(MatrixXd(ring.basis.transpose()));
        radius_.push_back(mean);
        rings_.push_back(std::move(ring));
    }
}

VectorXd Rings::reduced(const std::vector<double>& z, bool with_noise) const {
    const auto n = static_cast<Index>(count());
    VectorXd all = VectorXd::Constant(4 * n, std::numeric_limits<double>::quiet_NaN());
    for (Index i = 0; i < n; ++i) {
        const Ring& ring = rings_[static_cast<std::size_t>(i)];
        const auto spots = static_cast<Index>(ring.spots.size());
        VectorXd heights(spots);
        for (Index k = 0; k < spots; ++k) heights[k] = z[ring.spots[static_cast<std::size_t>(k)]];
        const VectorXd fit = ring.solve * heights;
        all[i] = fit[0];
        if (ring.leans) all[n + i] = fit[fit.size() - 2], all[2 * n + i] = fit[fit.size() - 1];
        if (noise_ > 0.0 && ring.spots.size() >= enough_for_roughness) {
            const double left = (heights - ring.basis * fit).squaredNorm() /
                                static_cast<double>(spots - fit.size());
            all[3 * n + i] = std::sqrt(left + (with_noise ? 0.0 : noise_ * noise_));
        }
    }
    return all;
}

MatrixXd Rings::instrument() const {
    const auto n = static_cast<Index>(count());
    MatrixXd c = MatrixXd::Zero(4 * n, 4 * n);
    for (Index i = 0; i < n; ++i) {
        const Ring& ring = rings_[static_cast<std::size_t>(i)];
        const MatrixXd of_fit = noise_ * noise_ * ring.solve * ring.solve.transpose();
        c(i, i) = of_fit(0, 0);
        // Of a root mean square over n spots, whatever the surface adds to it: at most noise^2/(2 n) each.
        c(3 * n + i, 3 * n + i) = noise_ * noise_ / (2.0 * static_cast<double>(ring.spots.size()));
        if (!ring.leans) continue;
        const Index a = of_fit.rows() - 2;
        const std::array<Index, 3> from{0, a, a + 1}, to{i, n + i, 2 * n + i};
        for (std::size_t p = 0; p < 3; ++p)
            for (std::size_t q = 0; q < 3; ++q) c(to[p], to[q]) = of_fit(from[p], from[q]);
    }
    return c;
}

}  // namespace diagnose
