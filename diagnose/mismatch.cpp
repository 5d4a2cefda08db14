// SPDX-License-Identifier: MIT
#include "diagnose/mismatch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>

namespace diagnose {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

using Series = std::vector<Index>;  // places in the long vector, in some order

double largest_window(const VectorXd& r, const Series& s) {
    const std::size_t n = s.size();
    if (n < 4) return 0.0;
    std::vector<double> sum(n + 1, 0.0), squares(n + 1, 0.0);
    for (std::size_t k = 0; k < n; ++k) {
        sum[k + 1] = sum[k] + r[s[k]];
        squares[k + 1] = squares[k] + r[s[k]] * r[s[k]];
    }
    double largest = 0.0;
    for (std::size_t length = n; length >= std::max<std::size_t>(4, n / 64); length /= 2) {
        const std::size_t hop = std::max<std::size_t>(1, length / 4);
        const auto count = static_cast<double>(length);
        for (std::size_t from = 0; from + length <= n; from += hop) {
            const double mean = (sum[from + length] - sum[from]) / std::sqrt(count);
            const double energy = normal_of_squares(squares[from + length] - squares[from], count);
            largest = std::max({largest, std::abs(mean), energy});
        }
        if (length < 8) break;
    }
    return largest;
}

std::vector<Series> by_recording(const Problem& p, const Whitener& w) {
    std::vector<Series> all;
    for (const Record& r : p.records)
        for (const Channel& c : r.channels) {
            Series s;
            for (std::size_t k = 0; k < c.recorded.size(); ++k)
                if (w.measured()[c.first + k]) s.push_back(static_cast<Index>(c.first + k));
            all.push_back(std::move(s));
        }
    return all;
}

// Rows of one channel, all recordings together, sorted by one variable of the state.
std::vector<Series> by_regime(const Problem& p, const Whitener& w, const Hypothesised& h,
                              const Fit& f) {
    std::map<std::string, std::vector<std::pair<double, Index>>> sorted;
    for (const Record& r : p.records) {
        const rigs::Curves state = r.model->variables(world_at(p, h, f.theta, r), r.ordinates);
        for (const auto& [variable, values] : state)
            for (const Channel& c : r.channels)
                for (std::size_t k = 0; k < c.recorded.size() && k < values.size(); ++k)
                    if (w.measured()[c.first + k] && std::isfinite(values[k]))
                        sorted[r.experiment->rig + "." + c.name + "." + variable].push_back(
                            {values[k], static_cast<Index>(c.first + k)});
    }
    std::vector<Series> all;
    for (auto& [name, rows] : sorted) {
        std::stable_sort(rows.begin(), rows.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        Series s;
        for (const auto& row : rows) s.push_back(row.second);
        all.push_back(std::move(s));
    }
    return all;
}

// Orthonormal cosines over the rows of one recording's channel, slowest first: [rows][as many as there are, 8 at most].
constexpr Index slowest = 8;
MatrixXd cosines(const Series& s) {
    const auto n = static_cast<Index>(s.size());
    MatrixXd c(n, std::min(n, slowest));
    for (Index m = 0; m < c.cols(); ++m)
        for (Index k = 0; k < n; ++k)
            c(k, m) = std::sqrt((m == 0 ? 1.0 : 2.0) / static_cast<double>(n)) *
                      std::cos(std::numbers::pi * static_cast<double>(m) *
                               (static_cast<double>(k) + 0.5) / static_cast<double>(n));
    return c;
}

// Where the statistics of a whitened residual look.
struct Places {
    MatrixXd directions;                   // [size][shapes]
    const std::vector<Shape>& shapes;      // whether a shape has two sides
    std::vector<Series> windows, regimes;  // by recording and channel; by channel and variable
    std::vector<std::string> channel;      // of each window
    std::vector<MatrixXd> slow;            // cosines of each window
};

// Sums of squares of the 1, 2, 4 and 8 slowest cosines, of one channel in all recordings and of all together: what each
// recording shows a little.
double largest_slow(const VectorXd& r, const Places& at) {
    using Sums = std::array<double, slowest>;
    std::map<std::string, std::pair<Sums, Sums>> of_channel;  // squares, and how many
    std::pair<Sums, Sums>& all = of_channel[""];
    for (std::size_t s = 0; s < at.windows.size(); ++s) {
        VectorXd rows(static_cast<Index>(at.windows[s].size()));
        for (Index k = 0; k < rows.size(); ++k)
            rows[k] = r[at.windows[s][static_cast<std::size_t>(k)]];
        const VectorXd c = at.slow[s].transpose() * rows;
        for (auto* of : {&all, &of_channel[at.channel[s]]})
            for (Index m = 0; m < c.size(); ++m)
                of->first[static_cast<std::size_t>(m)] += c[m] * c[m],
                    of->second[static_cast<std::size_t>(m)] += 1.0;
    }
    double largest = 0.0;
    for (const auto& [name, of] : of_channel) {
        double squares = 0.0, count = 0.0;
        for (std::size_t m = 0; m < of.first.size(); ++m) {
            squares += of.first[m], count += of.second[m];
            const bool told = (m & (m + 1)) == 0;  // 1, 2, 4, 8 of them
            if (told && count > 0.0) largest = std::max(largest, normal_of_squares(squares, count));
        }
    }
    return largest;
}

constexpr std::size_t families = 4;
using Families = std::array<double, families>;

Families statistics_of(const VectorXd& r, const Places& at) {
    Families t{};
    const VectorXd along = at.directions.transpose() * r;
    const std::vector<Shape>& shapes = at.shapes;
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        const double z = along[static_cast<Index>(k)];
        t[0] = std::max(t[0], shapes[k].two_sided ? std::abs(z) : z);
    }
    for (const Series& s : at.windows) t[1] = std::max(t[1], largest_window(r, s));
    for (const Series& s : at.regimes) t[2] = std::max(t[2], largest_window(r, s));
    t[3] = largest_slow(r, at);
    return t;
}

Places places(const Problem& p, const Whitener& w, const Hypothesised& h, const Fit& f,
              const std::vector<Shape>& list) {
    Places at{.directions = MatrixXd(static_cast<Index>(p.size), static_cast<Index>(list.size())),
              .shapes = list,
              .windows = by_recording(p, w),
              .regimes = by_regime(p, w, h, f),
              .channel = {},
              .slow = {}};
    for (std::size_t k = 0; k < list.size(); ++k)
        at.directions.col(static_cast<Index>(k)) = list[k].direction;
    for (const Record& r : p.records)
        for (const Channel& c : r.channels) at.channel.push_back(r.experiment->rig + "." + c.name);
    for (const Series& s : at.windows) at.slow.push_back(cosines(s));
    return at;
}

double share_at_least(const std::vector<double>& sorted, double value) {
    const auto at = std::lower_bound(sorted.begin(), sorted.end(), value);
    return (1.0 + static_cast<double>(sorted.end() - at)) /
           (1.0 + static_cast<double>(sorted.size()));
}

}  // namespace

double p_of_mismatch(const Problem& p, const Whitener& w, const Hypothesised& h, const Fit& f,
                     const std::vector<Shape>& list, const std::vector<double>& innovations,
                     std::uint64_t seed, int draws) {
    const Projection project(h.unknowns, f);
    const Places at = places(p, w, h, f, list);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::vector<Families> null;
    VectorXd z = VectorXd::Zero(static_cast<Index>(p.size));
    for (int n = 0; n < draws; ++n) {
        for (Index k = 0; k < z.size(); ++k) {
            if (!w.measured()[static_cast<std::size_t>(k)]) continue;
            z[k] =
                innovations.empty() ? normal(random) : innovations[random() % innovations.size()];
        }
        null.push_back(statistics_of(project(z), at));
    }
    std::array<std::vector<double>, families> sorted;
    for (std::size_t k = 0; k < families; ++k) {
        for (const Families& t : null) sorted[k].push_back(t[k]);
        std::sort(sorted[k].begin(), sorted[k].end());
    }
    // No family where nothing was to be had counts.
    const auto least = [&](const Families& t) {
        double p_least = 1.0;
        for (std::size_t k = 0; k < families; ++k)
            if (sorted[k].back() > 0.0)
                p_least = std::min(p_least, share_at_least(sorted[k], t[k]));
        return p_least;
    };
    const double observed = least(statistics_of(project(f.white), at));
    const auto as_small = std::count_if(null.begin(), null.end(),
                                        [&](const Families& t) { return least(t) <= observed; });
    // Beyond all draws of a family its trials cost a factor of their number at most.
    const double floor = 1.0 / (1.0 + draws);
    return observed <= 1.5 * floor ? std::min(1.0, static_cast<double>(families) * floor)
                                   : (1.0 + static_cast<double>(as_small)) / (1.0 + draws);
}

}  // namespace diagnose
