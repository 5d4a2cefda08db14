// SPDX-License-Identifier: MIT
#include "prove/figures.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace prove {

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
