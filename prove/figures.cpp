// SPDX-License-Identifier: MIT
#include "prove/figures.hpp"

#include <Eigen/QR>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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

// Values of a term's unknowns over their ranges: 24 for one unknown, some 70 for two, some 100 for a vibration.
std::vector<std::vector<double>> grid_of(const Term& t) {
    std::vector<std::vector<double>> grid{{}};
    for (std::size_t k = 0; k < t.unknowns.size(); ++k) {
        const Unknown& u = t.unknowns[k];
        const int points = t.unknowns.size() == 1   ? 24
                           : t.unknowns.size() == 2 ? (k == 0 ? 12 : 6)
                           : u.name == "frequency"  ? 24
                                                    : 2;
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
    for (const std::vector<double>& values : grid_of(t)) {
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

// A grain that lets go one row later moves a force curve by a step, which no slope tells of.
bool has_steps(const Skeleton& sk) { return sk.stated.front().rig == Rig::pull_off; }

// What the priors take of the truth itself: no wrong term is charged with that.
double penalty_of_truth(const Skeleton& sk, const std::vector<std::size_t>& list) {
    double sum = 0.0;
    for (const Unknown& n : sk.nuisances) {
        if (std::find(list.begin(), list.end(), static_cast<std::size_t>(n.experiment)) ==
            list.end())
            continue;
        const double off = value_of(n, sk.world, sk.truth) - n.mean;
        sum += off * off / (n.deviation * n.deviation);
    }
    return sum;
}

}  // namespace

const char* ordinate_of(const Setup& s) {
    if (s.rig == Rig::impact) return "angle";
    if (s.rig == Rig::pull_off) return s.cantilever_stiffness > 0.0 ? "displacement" : "separation";
    return "t";
}

double effective_count(const std::vector<Setup>& setups, const Noise& noise) {
    double n = 0.0;
    for (const Setup& s : setups) n += static_cast<double>(s.size());
    return n * (1.0 - noise.correlation) / (1.0 + noise.correlation);
}

double likelihood_ratio_power(double lambda, int freedom) {
    if (lambda < 1e-9) return 0.05;
    const double critical = gsl_cdf_chisq_Qinv(0.05, std::max(1, freedom));
    // Poisson mixture of central chi^2.
    double power = 0.0;
    const int mode = static_cast<int>(0.5 * lambda);
    const int width = 20 + static_cast<int>(12.0 * std::sqrt(0.5 * lambda));
    for (int k = std::max(0, mode - width); k <= mode + width; ++k)
        power += gsl_ran_poisson_pdf(static_cast<unsigned>(k), 0.5 * lambda) *
                 gsl_cdf_chisq_Q(critical, std::max(1, freedom) + 2.0 * k);
    return std::min(1.0, power);
}

Mismatch mismatch(const Skeleton& sk, const World& truth, std::vector<std::size_t> list) {
    if (list.empty()) list = with_role(sk, false);
    const std::vector<Setup> stated = chosen(sk.stated, list);
    const Eigen::VectorXd wanted = predict(truth, chosen(sk.truth, list));
    Mismatch m{base_fit(sk, list, wanted), {}, {}, 0, 0, 0};
    m.residual = wanted - predict(m.base.world, m.base.setups);
    m.whitened = whitened(stated, sk.noise, m.residual);
    m.n_eff = effective_count(stated, sk.noise);
    m.lambda = m.whitened.squaredNorm();
    m.idr = std::sqrt(m.lambda / m.n_eff);
    return m;
}

Fit fit_from(const Skeleton& sk, const std::vector<const Term*>& terms,
             const std::vector<std::size_t>& list, const Eigen::VectorXd& wanted, const Fit& begin,
             const std::vector<std::vector<double>>& starts, int iterations) {
    const std::vector<Unknown> unknowns = unknowns_with(sk, terms, list);
    // A few steps from every start, the rest from the best place.
    const int tries = starts.size() > 1 ? 3 : iterations;
    Fit best;
    double least = std::numeric_limits<double>::infinity();
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
        if (f.cost() < least) {
            least = f.cost();
            best = std::move(f);
        }
    }
    if (starts.size() == 1 || !std::isfinite(least)) return best;
    return fit(best.world, best.setups, unknowns, sk.noise, wanted, iterations, 1e-3);
}

namespace {

// Places ever nearer to the best value of the term's first unknown, where the base lines are refitted.
Fit closed_in(const Skeleton& sk, const Term& t, const std::vector<std::size_t>& list,
              const Eigen::VectorXd& wanted, Fit best) {
    if (!has_steps(sk) || t.unknowns.empty() || t.unknowns.front().in_world == nullptr) return best;
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

}  // namespace

Fit fit_with(const Skeleton& sk, const std::vector<const Term*>& terms,
             const std::vector<std::size_t>& list, const Eigen::VectorXd& wanted, const Fit& begin,
             int iterations) {
    return fit_from(sk, terms, list, wanted, begin, starts_of(terms, 6), iterations);
}

Separation separation(const Skeleton& sk, const World& truth, const std::vector<std::string>& right,
                      double enough, std::vector<std::size_t> list) {
    if (list.empty()) list = all_experiments(sk);
    const Eigen::VectorXd wanted = predict(truth, chosen(sk.truth, list));
    Separation best{std::numeric_limits<double>::infinity(), "", ""};
    const double own = penalty_of_truth(sk, list);
    const Fit begin = base_fit(sk, list, wanted);
    for (const Term& t : terms(sk.stated, sk.physics)) {
        if (std::find(right.begin(), right.end(), t.effect) != right.end()) continue;
        std::vector<std::vector<double>> starts = starts_of({&t}, enough == 0.0 ? 3 : 6);
        if (enough == 0.0)
            for (std::vector<double>& more : best_of_grid(sk, t, wanted, begin, 3))
                starts.push_back(std::move(more));
        Fit f = fit_from(sk, {&t}, list, wanted, begin, starts, 12);
        if (enough == 0.0) f = closed_in(sk, t, list, wanted, std::move(f));
        const double d = std::sqrt(std::max(0.0, f.cost() - own));
        if (d < best.d) best = {d, t.effect, t.channel};
        if (best.d < enough) break;
    }
    return best;
}

Separation pair_separation(const Skeleton& sk, const World& truth,
                           const std::vector<std::string>& right, int first) {
    const std::vector<std::size_t> list = with_role(sk, false);
    const Eigen::VectorXd wanted = predict(truth, chosen(sk.truth, list));
    const std::vector<Term> all = terms(sk.stated, sk.physics);
    const double own = penalty_of_truth(sk, list);
    const Fit begin = base_fit(sk, list, wanted);
    std::vector<std::pair<double, std::size_t>> singles;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Fit f = fit_with(sk, {&all[k]}, list, wanted, begin);
        singles.emplace_back(f.cost(), k);
    }
    std::sort(singles.begin(), singles.end());
    Separation best{std::sqrt(std::max(0.0, singles.front().first - own)),
                    all[singles.front().second].effect, all[singles.front().second].channel};
    for (std::size_t a = 0; a < singles.size() && static_cast<int>(a) < first; ++a) {
        for (std::size_t b = 0; b < all.size(); ++b) {
            const Term &one = all[singles[a].second], &other = all[b];
            const auto acts = [&](const Term& t) {
                return std::find(right.begin(), right.end(), t.effect) != right.end();
            };
            if (&one == &other || (acts(one) && acts(other))) continue;
            const Fit f = fit_with(sk, {&one, &other}, list, wanted, begin, 8);
            const double d = std::sqrt(std::max(0.0, f.cost() - own));
            if (d < best.d)
                best = {d, one.effect + " + " + other.effect, one.channel + " + " + other.channel};
        }
    }
    return best;
}

Span80 shortest_span(std::span<const double> at, std::span<const double> squares, double share) {
    std::vector<std::size_t> order(at.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return at[a] < at[b]; });
    double total = 0.0;
    for (const double s : squares) total += s;
    Span80 best{at[order.front()], at[order.back()]};
    double inside = 0.0;
    std::size_t left = 0;
    for (std::size_t right = 0; right < order.size(); ++right) {
        inside += squares[order[right]];
        while (inside - squares[order[left]] >= share * total && left < right)
            inside -= squares[order[left++]];
        if (inside >= share * total && at[order[right]] - at[order[left]] < best.to - best.from)
            best = {at[order[left]], at[order[right]]};
    }
    return best;
}

std::vector<TrueInterval> true_intervals(const Skeleton& sk, const Mismatch& m) {
    std::vector<TrueInterval> all;
    Eigen::Index first = 0;
    for (const std::size_t e : with_role(sk, false)) {
        const Setup& s = sk.stated[e];
        for (const Channel c : s.recorded) {
            const std::size_t n = s.at.size();
            std::vector<double> squares(n);
            double sum = 0.0, signed_sum = 0.0;
            for (std::size_t k = 0; k < n; ++k) {
                const Eigen::Index row = first + static_cast<Eigen::Index>(k);
                squares[k] = m.whitened[row] * m.whitened[row];
                sum += squares[k];
                if (std::isfinite(m.residual[row]))
                    signed_sum += m.residual[row] * std::abs(m.residual[row]);
            }
            first += static_cast<Eigen::Index>(n);
            const Span80 span = shortest_span(s.at, squares);
            const char* unit = s.rig == Rig::impact ? "rad" : s.rig == Rig::pull_off ? "m" : "s";
            all.push_back({s.id, to_string(c), ordinate_of(s), unit, span.from, span.to,
                           m.lambda > 0.0 ? sum / m.lambda : 0.0, signed_sum < 0.0 ? -1 : 1});
        }
    }
    return all;
}

double mean_nrmse(const std::vector<Setup>& setups, const Eigen::VectorXd& predicted,
                  const Eigen::VectorXd& recorded) {
    double sum = 0.0;
    int count = 0;
    Eigen::Index k = 0;
    for (const Setup& s : setups) {
        for (std::size_t c = 0; c < s.recorded.size(); ++c) {
            double low = std::numeric_limits<double>::infinity(), high = -low, squares = 0.0;
            int n = 0;
            for (std::size_t row = 0; row < s.at.size(); ++row, ++k) {
                if (!std::isfinite(recorded[k]) || !std::isfinite(predicted[k])) continue;
                low = std::min(low, recorded[k]), high = std::max(high, recorded[k]);
                squares += (predicted[k] - recorded[k]) * (predicted[k] - recorded[k]);
                ++n;
            }
            if (n == 0 || !(high > low)) continue;
            sum += 100.0 * std::sqrt(squares / n) / (high - low);
            ++count;
        }
    }
    return count > 0 ? sum / count : 0.0;
}

}  // namespace prove
