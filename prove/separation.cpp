// SPDX-License-Identifier: MIT
#include "prove/separation.hpp"

#include "prove/figures.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>

namespace prove {
namespace {

std::vector<Unknown> unknowns_with(const Skeleton& sk, const std::vector<const Term*>& terms,
                                   const std::vector<std::size_t>& list) {
    std::vector<Unknown> all = base_unknowns(sk, list);
    for (const Term* t : terms) all.insert(all.end(), t->unknowns.begin(), t->unknowns.end());
    return all;
}

// All combinations of starts of the terms' unknowns, at most `most`.
std::vector<std::vector<double>> starts_of(const std::vector<const Term*>& terms,
                                           std::size_t most) {
    std::vector<std::vector<double>> all{{}};
    for (const Term* t : terms) {
        for (const Unknown& u : t->unknowns) {
            std::vector<double> values = u.starts;
            if (values.empty()) values = {0.5 * (u.low + u.high)};
            std::vector<std::vector<double>> longer;
            for (const std::vector<double>& begun : all) {
                for (const double value : values) {
                    longer.push_back(begun);
                    longer.back().push_back(value);
                    if (longer.size() >= most) break;
                }
                if (longer.size() >= most) break;
            }
            all = std::move(longer);
        }
    }
    return all;
}

// A grain that lets go one row later moves a force curve by a step, which no slope tells of.
bool has_steps(const Skeleton& sk) { return sk.stated.front().rig == Rig::pull_off; }

// Values of a term's unknowns over their ranges: 24 for one unknown, 72 for two, 640 for a vibration; 240 where a force curve
// jumps, since what jumps a row too early looks like nothing that fits.
std::vector<std::vector<double>> grid_of(const Term& t, bool steps) {
    std::vector<std::vector<double>> grid{{}};
    for (std::size_t k = 0; k < t.unknowns.size(); ++k) {
        const Unknown& u = t.unknowns[k];
        const bool first = k == 0;
        const int points = t.unknowns.size() == 1   ? (steps ? 240 : 24)
                           : t.unknowns.size() == 2 ? (first ? (steps ? 40 : 12) : 6)
                           : u.name == "frequency"  ? 40
                                                    : 4;
        std::vector<std::vector<double>> finer;
        for (const std::vector<double>& begun : grid)
            for (int n = 0; n < points; ++n) {
                const double share = (n + 0.5) / points;
                finer.push_back(begun);
                finer.back().push_back(u.logarithmic ? u.low * std::pow(u.high / u.low, share)
                                                     : u.low + share * (u.high - u.low));
            }
        grid = std::move(finer);
    }
    return grid;
}

World with_values(const Term& t, const std::vector<double>& values, World w,
                  std::vector<Setup>& setups) {
    enable(t, w);
    Eigen::VectorXd theta(static_cast<Eigen::Index>(values.size()));
    for (std::size_t k = 0; k < values.size(); ++k)
        theta[static_cast<Eigen::Index>(k)] =
            std::clamp(values[k], t.unknowns[k].low, t.unknowns[k].high);
    put(t.unknowns, theta, w, setups);
    return w;
}

// The best places of the grid, where the unknowns of `begin` answer at first order.
std::vector<std::vector<double>> best_of_grid(const Skeleton& sk, const Term& t,
                                              const Eigen::VectorXd& wanted, const Fit& begin,
                                              std::size_t most) {
    if (t.unknowns.empty()) return {{}};
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(begin.slopes);
    const Eigen::Index known = begin.slopes.cols();
    std::vector<std::pair<double, std::vector<double>>> places;
    for (const std::vector<double>& values : grid_of(t, has_steps(sk))) {
        std::vector<Setup> setups = begin.setups;
        const World w = with_values(t, values, begin.world, setups);
        Eigen::VectorXd off = begin.misfit;
        off.head(wanted.size()) = whitened(setups, sk.noise, predict(w, setups) - wanted);
        const Eigen::VectorXd turned = qr.householderQ().adjoint() * off;
        const double left = turned.tail(turned.size() - known).squaredNorm();
        if (std::isfinite(left)) places.emplace_back(left, values);
    }
    std::sort(places.begin(), places.end());
    std::vector<std::vector<double>> best;
    for (std::size_t k = 0; k < std::min(most, places.size()); ++k)
        best.push_back(places[k].second);
    return best;
}

// The same with each stated condition told as it is: where nothing is noisy, the truth itself costs nothing.
Skeleton stated_truly(Skeleton sk) {
    for (Unknown& n : sk.nuisances) n.mean = value_of(n, sk.world, sk.truth);
    return sk;
}

Fit fit_from(const Skeleton& sk, const std::vector<const Term*>& terms,
             const std::vector<std::size_t>& list, const Eigen::VectorXd& wanted, const Fit& begin,
             const std::vector<std::vector<double>>& starts, int iterations) {
    const std::vector<Unknown> unknowns = unknowns_with(sk, terms, list);
    // A few steps from every start, the rest from the best place.
    const int tries = starts.size() > 1 ? 3 : iterations;
    Fit best;
    best.chi2 = std::numeric_limits<double>::infinity();  // no start gives a number
    for (const std::vector<double>& start : starts) {
        World w = begin.world;
        std::vector<Setup> setups = begin.setups;
        auto first = start.begin();
        for (const Term* t : terms) {
            const auto last = first + static_cast<std::ptrdiff_t>(t->unknowns.size());
            w = with_values(*t, {first, last}, w, setups);
            first = last;
        }
        if (has_steps(
                sk)) {  // the base line first: a step of all would be as short as a jump of the force allows
            const Fit near = fit(w, setups, base_unknowns(sk, list), sk.noise, wanted, 3, 1e-3);
            w = near.world, setups = near.setups;
        }
        Fit f = fit(w, setups, unknowns, sk.noise, wanted, tries, 1e-3);
        if (f.cost() < best.cost()) best = std::move(f);
    }
    if (starts.size() == 1 || !std::isfinite(best.cost())) return best;
    return fit(best.world, best.setups, unknowns, sk.noise, wanted, iterations, 1e-3);
}

// Places ever nearer to the best value of the term's first unknown, where the base lines are refitted.
Fit closed_in(const Skeleton& sk, const Term& t, const std::vector<std::size_t>& list,
              const Eigen::VectorXd& wanted, Fit best) {
    if (!has_steps(sk) || t.unknowns.empty() || t.unknowns.front().in_world == nullptr ||
        !std::isfinite(best.cost()))
        return best;
    const Unknown& u = t.unknowns.front();
    const std::vector<Unknown> others = base_unknowns(sk, list);
    for (double share = 0.05; share > 5e-4; share *= 0.5)
        for (const double sign : {-1.0, 1.0}) {
            World w = best.world;
            w.*u.in_world =
                std::clamp(w.*u.in_world * std::pow(u.high / u.low, sign * share), u.low, u.high);
            Fit f = fit(w, best.setups, others, sk.noise, wanted, 8, 1e-4);
            if (f.cost() < best.cost()) best = std::move(f);
        }
    return best;
}

// Fits to begin in: what is true but for the secret, since a wrong term that does the same finds the rest as it is, and the user's
// model refitted.
struct Begins {
    Fit truth, base;
};

// What is left by a wrong term at its best.
Fit searched(const Skeleton& sk, const Term& t, const std::vector<std::size_t>& list,
             const Eigen::VectorXd& wanted, const Begins& begins) {
    const std::vector<std::vector<double>> plain = starts_of({&t}, 3);
    std::vector<std::vector<double>> many = plain;
    for (std::vector<double>& more :
         best_of_grid(sk, t, wanted, begins.truth, t.unknowns.size() == 3 ? 10 : 3))
        many.push_back(std::move(more));
    Fit best = fit_from(sk, {&t}, list, wanted, begins.truth, many, 12);
    Fit other = fit_from(sk, {&t}, list, wanted, begins.base, plain, 12);
    if (other.cost() < best.cost()) best = std::move(other);
    return closed_in(sk, t, list, wanted, std::move(best));
}

Begins begins_of(const Skeleton& sk, const std::vector<std::size_t>& list,
                 const Eigen::VectorXd& wanted) {
    return {fit(sk.world, chosen(sk.truth, list), base_unknowns(sk, list), sk.noise, wanted, 0),
            base_fit(sk, list, wanted)};
}

}  // namespace

Fit fit_with(const Skeleton& sk, const std::vector<const Term*>& terms,
             const std::vector<std::size_t>& list, const Eigen::VectorXd& wanted, const Fit& begin,
             int iterations) {
    return fit_from(sk, terms, list, wanted, begin, starts_of(terms, 6), iterations);
}

Separation separation(const Skeleton& drawn, const World& truth,
                      const std::vector<std::string>& right, double enough,
                      std::vector<std::size_t> list) {
    const Skeleton sk = stated_truly(drawn);
    if (list.empty()) list = all_experiments(sk);
    const Eigen::VectorXd wanted = predict(truth, chosen(sk.truth, list));
    Separation best{std::numeric_limits<double>::infinity(), "", ""};
    const bool thorough = enough == 0.0;
    const Begins begins =
        thorough ? begins_of(sk, list, wanted) : Begins{{}, base_fit(sk, list, wanted)};
    for (const Term& t : terms(sk.stated, sk.physics)) {
        if (std::find(right.begin(), right.end(), t.effect) != right.end()) continue;
        const Fit f = thorough
                          ? searched(sk, t, list, wanted, begins)
                          : fit_from(sk, {&t}, list, wanted, begins.base, starts_of({&t}, 6), 12);
        const double d = std::sqrt(f.cost());
        if (d < best.d) best = {d, t.effect, t.channel};
        if (best.d < enough) break;
    }
    return best;
}

double left_by(const Skeleton& drawn, const World& truth, const Term& t,
               const std::vector<std::size_t>& list) {
    const Skeleton sk = stated_truly(drawn);
    const Eigen::VectorXd wanted = predict(truth, chosen(sk.truth, list));
    const Begins begins = begins_of(sk, list, wanted);
    Fit best = searched(sk, t, list, wanted, begins);
    // One of two that are true may do the work of both, with the free parameters far from where they are.
    constexpr std::size_t places = 5;
    std::vector<std::vector<double>> starts = starts_of({&t}, 3);
    starts.emplace_back();
    for (const Unknown& u : t.unknowns) starts.back().push_back(value_of(u, truth, sk.truth));
    for (const std::vector<double>& start : starts) {
        std::vector<Setup> setups = begins.truth.setups;
        const World w = with_values(t, start, begins.truth.world, setups);
        for (const World& far : far_from(sk, list, w, setups, wanted, places)) {
            Fit f = fit(far, setups, unknowns_with(sk, {&t}, list), sk.noise, wanted, 12, 1e-3);
            if (f.cost() < best.cost()) best = std::move(f);
        }
    }
    return best.cost();
}

Separation pair_separation(const Skeleton& drawn, const World& truth,
                           const std::vector<std::string>& right, int first) {
    const Skeleton sk = stated_truly(drawn);
    const std::vector<std::size_t> list = with_role(sk, false);
    const Eigen::VectorXd wanted = predict(truth, chosen(sk.truth, list));
    const std::vector<Term> all = terms(sk.stated, sk.physics);
    const Begins begins = begins_of(sk, list, wanted);
    std::vector<std::pair<Fit, std::size_t>> singles;
    for (std::size_t k = 0; k < all.size(); ++k)
        singles.emplace_back(searched(sk, all[k], list, wanted, begins), k);
    std::stable_sort(singles.begin(), singles.end(),
                     [](const auto& a, const auto& b) { return a.first.cost() < b.first.cost(); });
    Separation best{std::sqrt(singles.front().first.cost()), all[singles.front().second].effect,
                    all[singles.front().second].channel};
    for (std::size_t a = 0; a < singles.size() && static_cast<int>(a) < first; ++a) {
        const auto& [alone, which] = singles[a];
        if (!std::isfinite(alone.cost())) break;
        const Term& one = all[which];
        std::vector<double> values;
        for (const Unknown& u : one.unknowns)
            values.push_back(value_of(u, alone.world, alone.setups));
        for (const Term& other : all) {
            const auto acts = [&](const Term& t) {
                return std::find(right.begin(), right.end(), t.effect) != right.end();
            };
            if (&one == &other || (acts(one) && acts(other))) continue;
            // The other beside the one at its best.
            std::vector<std::vector<double>> starts;
            for (const std::vector<double>& more : best_of_grid(sk, other, wanted, alone, 3)) {
                starts.push_back(values);
                starts.back().insert(starts.back().end(), more.begin(), more.end());
            }
            if (starts.empty()) continue;
            const Fit f = fit_from(sk, {&one, &other}, list, wanted, alone, starts, 8);
            const double d = std::sqrt(f.cost());
            if (d < best.d)
                best = {d, one.effect + " + " + other.effect, one.channel + " + " + other.channel};
        }
    }
    return best;
}

}  // namespace prove
