// SPDX-License-Identifier: MIT
#include "diagnose/pile_emulator.hpp"

#include "diagnose/candidates.hpp"
#include "statistics/hyperparameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace diagnose {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr auto kernel = statistics::Kernel::squared_exponential;
constexpr Index fewest_neighbours = 40;  // runs that a covariance is known from
constexpr Index like_alone = 8;          // runs that tell how far heaps scatter there

// One heap scatters by a good part of what parameters can do.
statistics::HyperparameterPrior prior() {
    statistics::HyperparameterPrior p;
    p.noise = {0.4, 0.8};
    return p;
}

// Sums of squares of `rows` residuals as a covariance, drawn a share of the way towards one that knows but the deviations and how
// alike neighbours of a channel are: correlation^distance (Ledoit & Wolf 2004 draw towards the deviations alone, which
// hides that the shape of a flank scatters less than its height).
MatrixXd drawn_to_neighbours(const MatrixXd& squares, double rows, double share,
                             const std::vector<Index>& channel) {
    const MatrixXd c = squares / rows;
    const VectorXd sd = c.diagonal().cwiseMax(1e-300).cwiseSqrt();
    double sum = 0.0, count = 0.0;
    for (Index k = 1; k < c.rows(); ++k)
        if (channel[static_cast<std::size_t>(k)] == channel[static_cast<std::size_t>(k - 1)])
            sum += c(k, k - 1) / (sd[k] * sd[k - 1]), count += 1.0;
    const double alike = count > 0.0 ? std::clamp(sum / count, 0.0, 0.99) : 0.0;
    MatrixXd target = MatrixXd::Zero(c.rows(), c.cols());
    for (Index i = 0; i < c.rows(); ++i)
        for (Index j = 0; j < c.cols(); ++j)
            if (channel[static_cast<std::size_t>(i)] == channel[static_cast<std::size_t>(j)])
                target(i, j) = sd[i] * sd[j] * std::pow(alike, std::abs(i - j));
    return (1.0 - share) * c + share * target;
}

// About 0, of residuals [rows][numbers]; numbers of one channel stand together. The share is the one by which each row is told best
// from the others; then all is made wider by what those rows are further off than that says.
MatrixXd covariance_of(const MatrixXd& residuals, const std::vector<Index>& channel) {
    const auto rows = static_cast<double>(residuals.rows()),
               numbers = static_cast<double>(residuals.cols());
    const MatrixXd squares = residuals.transpose() * residuals;
    double best = std::numeric_limits<double>::max(), chosen = 1.0, wider = 1.0;
    for (const double share : {0.1, 0.2, 0.35, 0.5, 0.7, 0.9}) {
        double cost = 0.0, distance = 0.0;
        for (Index r = 0; r < residuals.rows(); ++r) {
            const VectorXd e = residuals.row(r);
            const Eigen::LDLT<MatrixXd> ldlt(
                drawn_to_neighbours(squares - e * e.transpose(), rows - 1.0, share, channel));
            const double own = e.dot(ldlt.solve(e));
            distance += own / (rows * numbers);
            cost += own + ldlt.vectorD().cwiseMax(1e-300).array().log().sum();
        }
        if (cost < best) best = cost, chosen = share, wider = distance;
    }
    return std::max(1.0, wider) * drawn_to_neighbours(squares, rows, chosen, channel);
}

}  // namespace

PileEmulator::PileEmulator(MatrixXd x, MatrixXd y, Numbers numbers, Learned learned, int threads)
    : x_(std::move(x)),
      y_(std::move(y)),
      numbers_(std::move(numbers)),
      learned_(std::move(learned)),
      process_of_(static_cast<std::size_t>(y_.cols()), -1) {
    for (const Index k : numbers_.moved)
        y_.col(k) = y_.col(k).unaryExpr([this](double v) { return stretched(v); });
    const bool anew = learned_.hyper.empty();
    if (anew) {
        learned_.hyper.resize(static_cast<std::size_t>(y_.cols()));
        learned_.slopes = VectorXd::Zero(x_.cols());
        for (int round = 0; round < 2; ++round) fit(true, threads), learn_scatter();
    }
    fit(anew, threads);
}

void PileEmulator::fit(bool anew, int threads) {
    std::vector<Index> told = numbers_.moved;
    if (numbers_.tilted) told.insert(told.end(), numbers_.lean.begin(), numbers_.lean.end());
    const VectorXd factors = scatter();
    std::vector<std::optional<statistics::GaussianProcess>> made(told.size());
    in_parallel(told.size(), threads, [&](std::size_t n) {
        statistics::Hyperparameters& h = learned_.hyper[static_cast<std::size_t>(told[n])];
        const statistics::Data data{x_, y_.col(told[n]), factors};
        if (anew) h = statistics::most_probable(data, kernel, prior());
        made[n].emplace(data, kernel, h);
    });
    left_out_ = y_;
    processes_.clear();
    for (std::size_t n = 0; n < told.size(); ++n) {
        process_of_[static_cast<std::size_t>(told[n])] = static_cast<int>(n);
        left_out_.col(told[n]) -= made[n]->left_one_out().mean;
        processes_.push_back(std::move(*made[n]));
    }
}

// Least squares of the logarithm of what each run is off by, rms over the numbers that move, over its scatter so far. A slope is
// thought to be 0 give or take 1.
void PileEmulator::learn_scatter() {
    if (numbers_.moved.empty()) return;
    const VectorXd factors = scatter();
    VectorXd off = VectorXd::Zero(x_.rows());
    for (const Index k : numbers_.moved) {
        const VectorXd e = left_out_.col(k).cwiseQuotient(factors);
        off += e.cwiseAbs2() / std::max(1e-300, e.squaredNorm());
    }
    const VectorXd logs = 0.5 * off.cwiseMax(1e-12).array().log();
    // A chi squared's logarithm scatters by about 1 where few numbers are independent.
    const MatrixXd about = x_.rowwise() - x_.colwise().mean();
    MatrixXd normal = about.transpose() * about;
    normal.diagonal().array() += 1.0;
    learned_.slopes +=
        normal.ldlt().solve(about.transpose() * (logs.array() - logs.mean()).matrix());
}

double PileEmulator::stretched(double y) const {
    constexpr double least = -0.9;  // an instrument's noise may take a low spot below nothing
    return std::log1p(std::max(least, y / numbers_.knee));
}

VectorXd PileEmulator::mean(const VectorXd& x) const {
    VectorXd m = VectorXd::Zero(y_.cols());
    for (Index k = 0; k < m.size(); ++k)
        if (const int p = process_of_[static_cast<std::size_t>(k)]; p >= 0)
            m[k] = processes_[static_cast<std::size_t>(p)].at(x.transpose()).mean[0];
    // The mean of what is normal in the logarithm, with the scatter that there is here.
    const double factor = std::exp(learned_.slopes.dot(x));
    for (const Index k : numbers_.moved) {
        const double scatter = factor * learned_.hyper[static_cast<std::size_t>(k)].noise;
        m[k] = numbers_.knee * std::expm1(m[k] + 0.5 * scatter * scatter);
    }
    return m;
}

// By what the others say of each run: its own scatter must not decide whether it is looked at.
std::vector<Index> PileEmulator::nearest(const VectorXd& like, Index most) const {
    std::vector<std::pair<double, Index>> sorted;
    for (Index r = 0; r < y_.rows(); ++r) {
        double sum = 0.0;
        for (const Index k : numbers_.moved)
            sum += std::pow((y_(r, k) - left_out_(r, k) - stretched(like[k])) /
                                learned_.hyper[static_cast<std::size_t>(k)].noise,
                            2);
        sorted.push_back({sum, r});
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    sorted.resize(static_cast<std::size_t>(std::min(y_.rows(), most)));
    std::vector<Index> runs;
    for (const auto& [far, r] : sorted) runs.push_back(r);
    return runs;
}

double PileEmulator::share_of_error(const VectorXd& like) const {
    const std::vector<Index> runs = nearest(like, like_alone);
    const VectorXd factors = scatter();
    double sum = 0.0, count = 0.0;
    for (const Index k : numbers_.moved) {
        const double noise = learned_.hyper[static_cast<std::size_t>(k)].noise;
        const VectorXd variance =
            processes_[static_cast<std::size_t>(process_of_[static_cast<std::size_t>(k)])]
                .at(x_(runs, Eigen::all))
                .variance;
        for (Index r = 0; r < variance.size(); ++r) {
            const double own = noise * factors[runs[static_cast<std::size_t>(r)]];
            sum += variance[r] / (variance[r] + own * own), count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : 0.0;
}

MatrixXd PileEmulator::covariance(const VectorXd& like) const {
    const std::vector<Index> runs = nearest(like, std::max(fewest_neighbours, y_.rows() / 2));
    const auto most = static_cast<Index>(runs.size());
    const VectorXd factors = scatter();
    const std::vector<Index> alone(runs.begin(), runs.begin() + std::min(most, like_alone));
    const double here = std::sqrt(factors(alone).squaredNorm() / static_cast<double>(alone.size()));
    const auto residuals = [&](const std::vector<Index>& numbers) {
        MatrixXd part(most, static_cast<Index>(numbers.size()));
        for (Index r = 0; r < most; ++r)
            for (std::size_t k = 0; k < numbers.size(); ++k) {
                const Index run = runs[static_cast<std::size_t>(r)];
                part(r, static_cast<Index>(k)) = left_out_(run, numbers[k]) * here / factors[run];
            }
        return part;
    };
    const Index rings = y_.cols() / 4;
    const auto channels = [&](const std::vector<Index>& numbers) {
        std::vector<Index> list;
        for (const Index k : numbers) list.push_back(k / rings);
        return list;
    };
    MatrixXd whole = MatrixXd::Zero(y_.cols(), y_.cols());
    const auto put = [&](const std::vector<Index>& numbers, const MatrixXd& c) {
        for (std::size_t a = 0; a < numbers.size(); ++a)
            for (std::size_t b = 0; b < numbers.size(); ++b)
                whole(numbers[a], numbers[b]) = c(static_cast<Index>(a), static_cast<Index>(b));
    };
    VectorXd size(static_cast<Index>(numbers_.moved.size()));
    for (Index k = 0; k < size.size(); ++k)
        size[k] = numbers_.knee + std::max(0.0, like[numbers_.moved[static_cast<std::size_t>(k)]]);
    put(numbers_.moved, size.asDiagonal() *
                            covariance_of(residuals(numbers_.moved), channels(numbers_.moved)) *
                            size.asDiagonal());
    // Leans to the two sides scatter alike: one covariance from both.
    const MatrixXd lean = residuals(numbers_.lean), across = residuals(numbers_.across);
    MatrixXd both(2 * most, lean.cols());
    both << lean, across;
    const MatrixXd c = covariance_of(both, channels(numbers_.lean));
    put(numbers_.lean, c), put(numbers_.across, c);
    return whole;
}

}  // namespace diagnose
