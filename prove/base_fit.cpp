// SPDX-License-Identifier: MIT
#include "prove/figures.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace prove {
namespace {

World started(const Skeleton& sk) {
    World w = sk.world;
    for (const Stated& p : sk.parameters) w.*p.place = p.free ? p.truth : p.start;
    return w;
}

// The first `share` of the rows of what is recorded over time, and all rows of other rigs.
struct Early {
    std::vector<Setup> setups;
    Eigen::VectorXd wanted;
};
Early early_rows(std::vector<Setup> setups, const Eigen::VectorXd& wanted, double share) {
    std::vector<double> kept;
    Eigen::Index first = 0;
    for (Setup& s : setups) {
        const auto n = static_cast<Eigen::Index>(s.at.size());
        if (s.rig == Rig::drop || s.rig == Rig::incline)
            s.at.resize(static_cast<std::size_t>(share * static_cast<double>(n)));
        for (std::size_t c = 0; c < s.recorded.size(); ++c, first += n)
            for (std::size_t k = 0; k < s.at.size(); ++k)
                kept.push_back(wanted[first + static_cast<Eigen::Index>(k)]);
    }
    return {std::move(setups),
            Eigen::Map<const Eigen::VectorXd>(kept.data(), static_cast<Eigen::Index>(kept.size()))};
}

// The free parameters of the user's model over their ranges, 81 places; where one alone is free, or a share of its range on both
// sides of `start`.
std::vector<World> grid_of(const World& start, const std::vector<Unknown>& free,
                           double share = 1.0) {
    constexpr std::size_t most = 81;
    const int points = free.size() == 1 ? static_cast<int>(most) : 9;
    std::vector<World> grid{start};
    for (const Unknown& u : free) {
        std::vector<World> finer;
        // Ranges of more than a decade in the logarithm: a friction of 0.05 is no neighbour of 0.1.
        const bool logarithmic = u.low > 0.0 && u.high > 10.0 * u.low;
        const auto inner = [&](double v) {
            return logarithmic ? std::log(v / u.low) / std::log(u.high / u.low)
                               : (v - u.low) / (u.high - u.low);
        };
        const double low =
            share == 1.0 ? 0.0 : std::clamp(inner(start.*u.in_world) - share, 0.0, 1.0);
        const double high =
            share == 1.0 ? 1.0 : std::clamp(inner(start.*u.in_world) + share, 0.0, 1.0);
        for (const World& w : grid)
            for (int k = 0; k < points; ++k) {
                const double x = low + (high - low) * (k + 0.5) / points;
                finer.push_back(w);
                finer.back().*u.in_world = logarithmic ? u.low * std::pow(u.high / u.low, x)
                                                       : u.low + x * (u.high - u.low);
            }
        if (finer.size() <= most) grid = std::move(finer);
    }
    return grid;
}

// The worlds that leave least, once the unknowns of `begin` have answered at first order.
std::vector<World> best_of(const std::vector<World>& grid, const Early& by, const Noise& noise,
                           const Fit& begin, std::size_t most) {
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(begin.slopes);
    const Eigen::Index known = begin.slopes.cols();
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < grid.size(); ++k) {
        Eigen::VectorXd off = begin.misfit;
        off.head(by.wanted.size()) =
            whitened(by.setups, noise, predict(grid[k], by.setups) - by.wanted);
        if (known > 0) off = (qr.householderQ().adjoint() * off).eval();
        order.emplace_back(off.tail(off.size() - known).squaredNorm(), k);
    }
    std::sort(order.begin(), order.end());
    std::vector<World> best;
    for (std::size_t k = 0; k < std::min(most, order.size()); ++k)
        best.push_back(grid[order[k].second]);
    return best;
}

}  // namespace

Fit base_fit(const Skeleton& sk, const std::vector<std::size_t>& list,
             const Eigen::VectorXd& wanted) {
    constexpr int short_fit = 5;
    constexpr std::size_t by_all = 3, by_early = 2, fitted_out = 2;
    const std::vector<Unknown> unknowns = base_unknowns(sk, list);
    std::vector<Unknown> nuisances, free;
    for (const Unknown& u : unknowns) (u.in_world == nullptr ? nuisances : free).push_back(u);
    const auto fitted = [&](const World& w, const std::vector<Setup>& setups,
                            const std::vector<Unknown>& of, const Eigen::VectorXd& to,
                            int iterations) {
        return fit(w, setups, of, sk.noise, to, iterations);
    };
    const Early all{chosen(sk.stated, list), wanted};
    const bool over_time =
        all.setups.front().rig == Rig::drop || all.setups.front().rig == Rig::incline;
    std::vector<World> starts{started(sk)};
    const auto add = [&](const std::vector<World>& grid, const Fit& begin,
                         const Eigen::VectorXd& to, std::size_t most) {
        for (const World& w : best_of(grid, {begin.setups, to}, sk.noise, begin, most))
            starts.push_back(w);
    };
    if (!free.empty()) {
        const std::vector<World> grid = grid_of(starts[0], free);
        const Fit begin = fitted(starts[0], all.setups, nuisances, wanted, 3);
        add(grid, begin, wanted, by_all);
        if (over_time) {
            const Early e = early_rows(all.setups, wanted, 0.4);
            add(grid, fitted(starts[0], e.setups, nuisances, e.wanted, 3), e.wanted, by_early);
        } else if (free.size() == 1) {
            add(grid_of(starts[1], free, 0.02), begin, wanted, 1);
            add(grid_of(starts.back(), free, 0.001), begin, wanted, 1);
        }
    }
    std::vector<Fit> fits;
    for (const World& w : starts) {
        // Nuisances first: a step of all would be as short as a jump of the force allows.
        const Fit near = fitted(w, all.setups, nuisances, wanted, 3);
        fits.push_back(fitted(near.world, near.setups, unknowns, wanted, short_fit));
        if (!over_time) continue;
        World staged = w;
        std::vector<Setup> setups = all.setups;
        for (const double share : {0.25, 0.5, 0.75, 1.0}) {
            const Early e = early_rows(setups, wanted, share);
            const Fit f = fitted(staged, e.setups, unknowns, e.wanted, short_fit);
            staged = f.world, setups = f.setups;
            for (std::size_t k = 0; k < setups.size(); ++k) setups[k].at = all.setups[k].at;
            if (share == 1.0) fits.push_back(f);
        }
    }
    std::sort(fits.begin(), fits.end(),
              [](const Fit& a, const Fit& b) { return a.cost() < b.cost(); });
    Fit best;
    for (std::size_t k = 0; k < std::min(fitted_out, fits.size()); ++k) {
        Fit f = fitted(fits[k].world, fits[k].setups, unknowns, wanted, 20);
        if (k == 0 || f.cost() < best.cost()) best = std::move(f);
    }
    return best;
}

std::vector<World> far_from(const Skeleton& sk, const std::vector<std::size_t>& list,
                            const World& world, std::vector<Setup> setups,
                            const Eigen::VectorXd& wanted, std::size_t most) {
    std::vector<Unknown> nuisances, free;
    for (const Unknown& u : base_unknowns(sk, list))
        (u.in_world == nullptr ? nuisances : free).push_back(u);
    if (free.empty()) return {};
    const Fit begin = fit(world, setups, nuisances, sk.noise, wanted, 3);
    return best_of(grid_of(world, free), {begin.setups, wanted}, sk.noise, begin, most);
}

}  // namespace prove
