// SPDX-License-Identifier: MIT
#include "diagnose/pile_emulator.hpp"

#include "diagnose/candidates.hpp"
#include "statistics/hyperparameters.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace diagnose {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr auto kernel = statistics::Kernel::squared_exponential;
constexpr Index fewest_neighbours = 40;

// One heap scatters by a good part of what parameters can do.
statistics::HyperparameterPrior prior() {
    statistics::HyperparameterPrior p;
    p.noise = {0.4, 0.8};
    return p;
}

// About 0, of residuals [rows][numbers]. Correlations are shrunk by numbers/rows; the mean of the inverse of a covariance from `rows`
// draws is too large by rows/(rows - numbers - 1), and so is this one made wider.
MatrixXd covariance_of(const MatrixXd& residuals) {
    const auto rows = static_cast<double>(residuals.rows()),
               numbers = static_cast<double>(residuals.cols());
    MatrixXd c = residuals.transpose() * residuals / std::max(1.0, rows - numbers - 1.0);
    const VectorXd own = c.diagonal();
    c *= 1.0 - std::min(0.5, numbers / rows);
    c.diagonal() = own;
    return c;
}

}  // namespace

PileEmulator::PileEmulator(MatrixXd x, MatrixXd y, Numbers numbers,
                           std::vector<statistics::Hyperparameters> hyper, int threads)
    : x_(std::move(x)),
      y_(std::move(y)),
      left_out_(y_),
      numbers_(std::move(numbers)),
      hyper_(std::move(hyper)),
      process_of_(static_cast<std::size_t>(y_.cols()), -1) {
    std::vector<Index> told = numbers_.moved;
    if (numbers_.tilted) told.insert(told.end(), numbers_.lean.begin(), numbers_.lean.end());
    const bool anew = hyper_.empty();
    if (anew) hyper_.resize(static_cast<std::size_t>(y_.cols()));
    std::vector<std::optional<statistics::GaussianProcess>> made(told.size());
    in_parallel(told.size(), threads, [&](std::size_t n) {
        const Index k = told[n];
        statistics::Hyperparameters& h = hyper_[static_cast<std::size_t>(k)];
        const statistics::Data data{x_, y_.col(k)};
        if (anew) h = statistics::most_probable(data, kernel, prior());
        made[n].emplace(data, kernel, h);
    });
    for (std::size_t n = 0; n < told.size(); ++n) {
        process_of_[static_cast<std::size_t>(told[n])] = static_cast<int>(n);
        left_out_.col(told[n]) = y_.col(told[n]) - made[n]->left_one_out().mean;
        processes_.push_back(std::move(*made[n]));
    }
}

VectorXd PileEmulator::mean(const VectorXd& x) const {
    VectorXd m = VectorXd::Zero(y_.cols());
    for (Index k = 0; k < m.size(); ++k)
        if (const int p = process_of_[static_cast<std::size_t>(k)]; p >= 0)
            m[k] = processes_[static_cast<std::size_t>(p)].at(x.transpose()).mean[0];
    return m;
}

std::vector<Index> PileEmulator::nearest(const VectorXd& like) const {
    std::vector<std::pair<double, Index>> sorted;
    for (Index r = 0; r < y_.rows(); ++r) {
        double sum = 0.0;
        for (const Index k : numbers_.moved)
            sum += std::pow((y_(r, k) - like[k]) / hyper_[static_cast<std::size_t>(k)].noise, 2);
        sorted.push_back({sum, r});
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    sorted.resize(
        static_cast<std::size_t>(std::min(y_.rows(), std::max(fewest_neighbours, y_.rows() / 2))));
    std::vector<Index> runs;
    for (const auto& [far, r] : sorted) runs.push_back(r);
    return runs;
}

double PileEmulator::share_of_error(const VectorXd& like) const {
    const std::vector<Index> runs = nearest(like);
    double sum = 0.0, count = 0.0;
    for (const Index k : numbers_.moved) {
        const double noise = hyper_[static_cast<std::size_t>(k)].noise;
        const VectorXd variance =
            processes_[static_cast<std::size_t>(process_of_[static_cast<std::size_t>(k)])]
                .at(x_(runs, Eigen::all))
                .variance;
        for (const double v : variance) sum += v / (v + noise * noise), count += 1.0;
    }
    return count > 0.0 ? sum / count : 0.0;
}

MatrixXd PileEmulator::covariance(const VectorXd& like) const {
    const std::vector<Index> runs = nearest(like);
    const auto most = static_cast<Index>(runs.size());
    const auto residuals = [&](const std::vector<Index>& numbers) {
        MatrixXd part(most, static_cast<Index>(numbers.size()));
        for (Index r = 0; r < most; ++r)
            for (std::size_t k = 0; k < numbers.size(); ++k)
                part(r, static_cast<Index>(k)) =
                    left_out_(runs[static_cast<std::size_t>(r)], numbers[k]);
        return part;
    };
    MatrixXd whole = MatrixXd::Zero(y_.cols(), y_.cols());
    const auto put = [&](const std::vector<Index>& numbers, const MatrixXd& c) {
        for (std::size_t a = 0; a < numbers.size(); ++a)
            for (std::size_t b = 0; b < numbers.size(); ++b)
                whole(numbers[a], numbers[b]) = c(static_cast<Index>(a), static_cast<Index>(b));
    };
    put(numbers_.moved, covariance_of(residuals(numbers_.moved)));
    // Leans to the two sides scatter alike: one covariance from both.
    const MatrixXd lean = residuals(numbers_.lean), across = residuals(numbers_.across);
    MatrixXd both(2 * most, lean.cols());
    both << lean, across;
    const MatrixXd c = covariance_of(both);
    put(numbers_.lean, c), put(numbers_.across, c);
    return whole;
}

}  // namespace diagnose
