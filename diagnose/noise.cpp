// SPDX-License-Identifier: MIT
#include "diagnose/noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace diagnose {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr std::size_t long_enough = 24;  // rows from which a spectrum says more than a variance

double range_of(const std::vector<double>& values) {
    double low = 1e300, high = -1e300;
    for (const double v : values)
        if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
    return high > low ? high - low : 0.0;
}

// Squared coefficients of the orthonormal cosine transform above a sixteenth of all frequencies, with cos of their frequency.
struct Spectrum {
    std::vector<double> power, cosine;
};

Spectrum upper_spectrum(const std::vector<double>& r) {
    const std::size_t n = r.size();
    Spectrum s;
    for (std::size_t m = std::max<std::size_t>(1, n / 16); m < n; ++m) {
        double sum = 0.0;
        const double w = std::numbers::pi * static_cast<double>(m) / static_cast<double>(n);
        // cos((k + 1/2) w) by the two-term recurrence.
        double c0 = std::cos(-0.5 * w), c1 = std::cos(0.5 * w);
        const double twice = 2.0 * std::cos(w);
        for (std::size_t k = 0; k < n; ++k) {
            sum += r[k] * c1;
            const double c2 = twice * c1 - c0;
            c0 = c1, c1 = c2;
        }
        s.power.push_back(2.0 / static_cast<double>(n) * sum * sum);
        s.cosine.push_back(std::cos(w));
    }
    return s;
}

double shape(double rho, double cosine) {
    return (1.0 - rho * rho) / (1.0 - 2.0 * rho * cosine + rho * rho);
}

// Variance that fits best at this rho, where none is stated.
double best_variance(const Spectrum& s, double rho) {
    double sum = 0.0;
    for (std::size_t m = 0; m < s.power.size(); ++m) sum += s.power[m] / shape(rho, s.cosine[m]);
    return sum / static_cast<double>(std::max<std::size_t>(1, s.power.size()));
}

double log_likelihood(const Spectrum& s, double rho, double stated) {
    const double variance =
        stated > 0.0 ? stated * stated : std::max(best_variance(s, rho), 1e-300);
    double sum = 0.0;
    for (std::size_t m = 0; m < s.power.size(); ++m) {
        const double density = variance * shape(rho, s.cosine[m]);
        sum -= 0.5 * (std::log(density) + s.power[m] / density);
    }
    return sum;
}

struct Series {
    std::size_t record, channel;
    std::vector<double> residual;  // measured rows, in order
};

// Posterior mean over rho: half of the prior on none, half even over 0.02 to 0.96.
double correlation(const std::vector<const Series*>& all, const Problem& p) {
    constexpr int count = 48;
    std::array<double, count + 1> log_like{};
    for (const Series* s : all) {
        if (s->residual.size() < long_enough) continue;
        const Spectrum spectrum = upper_spectrum(s->residual);
        const double stated = p.records[s->record].channels[s->channel].stated_noise;
        for (int k = 0; k <= count; ++k)
            log_like[static_cast<std::size_t>(k)] += log_likelihood(spectrum, 0.02 * k, stated);
    }
    const double top = *std::max_element(log_like.begin(), log_like.end());
    double sum = std::exp(log_like[0] - top), mean = 0.0, none = sum;
    for (int k = 1; k <= count; ++k) {
        const double weight = std::exp(log_like[static_cast<std::size_t>(k)] - top) / count;
        sum += weight, mean += weight * 0.02 * k;
    }
    return none > 0.5 * sum ? 0.0 : mean / (sum - none);
}

}  // namespace

Whitener::Whitener(const Problem& p, const Noise& noise)
    : previous_(p.size, -1), a_(p.size, 0.0), b_(p.size, 0.0), measured_(p.size, false) {
    for (std::size_t j = 0; j < p.records.size(); ++j) {
        const Record& r = p.records[j];
        if (r.covariance.size() > 0) {
            add_block(r);
            continue;
        }
        for (std::size_t c = 0; c < r.channels.size(); ++c) {
            const Channel& channel = r.channels[c];
            const auto [sigma, rho] = noise[j][c];
            int last = -1;
            for (std::size_t k = 0; k < channel.recorded.size(); ++k) {
                if (!std::isfinite(channel.recorded[k])) continue;
                const std::size_t at = channel.first + k;
                const bool new_branch = k > 0 && !r.ordinates.retract.empty() &&
                                        r.ordinates.retract[k] != r.ordinates.retract[k - 1];
                if (new_branch) last = -1;
                const double phi =
                    last < 0 || rho == 0.0
                        ? 0.0
                        : std::pow(rho, static_cast<double>(static_cast<int>(k) - last));
                a_[at] = 1.0 / (sigma * std::sqrt(1.0 - phi * phi));
                b_[at] = phi * a_[at];
                previous_[at] = last < 0 ? -1 : static_cast<int>(channel.first) + last;
                measured_[at] = true;
                log_norm_ += std::log(a_[at]) - 0.5 * std::log(two_pi);
                ++rows_;
                last = static_cast<int>(k);
            }
        }
    }
}

void Whitener::add_block(const Record& r) {
    Block block;
    const std::size_t first = r.channels.front().first;
    for (const Channel& c : r.channels)
        for (std::size_t k = 0; k < c.recorded.size(); ++k)
            if (std::isfinite(c.recorded[k]))
                block.rows.push_back(static_cast<Eigen::Index>(c.first + k));
    const auto n = static_cast<Eigen::Index>(block.rows.size());
    Eigen::MatrixXd measured(n, n);
    for (Eigen::Index a = 0; a < n; ++a)
        for (Eigen::Index b = 0; b < n; ++b)
            measured(a, b) = r.covariance(
                block.rows[static_cast<std::size_t>(a)] - static_cast<Eigen::Index>(first),
                block.rows[static_cast<std::size_t>(b)] - static_cast<Eigen::Index>(first));
    block.factor.compute(measured);
    const Eigen::MatrixXd lower = block.factor.matrixL();
    for (Eigen::Index k = 0; k < n; ++k) {
        measured_[static_cast<std::size_t>(block.rows[static_cast<std::size_t>(k)])] = true;
        log_norm_ -= std::log(lower(k, k)) + 0.5 * std::log(two_pi);
    }
    rows_ += block.rows.size();
    blocks_.push_back(std::move(block));
}

Eigen::VectorXd Whitener::operator()(const Eigen::VectorXd& residual) const {
    Eigen::VectorXd z = Eigen::VectorXd::Zero(residual.size());
    for (const Block& block : blocks_) {
        const Eigen::VectorXd own = residual(block.rows);
        const Eigen::VectorXd white = block.factor.matrixL().solve(own);
        z(block.rows) = white;
    }
    for (std::size_t k = 0; k < measured_.size(); ++k) {
        if (a_[k] == 0.0) continue;
        const auto i = static_cast<Eigen::Index>(k);
        z[i] = a_[k] * residual[i] - (previous_[k] < 0 ? 0.0 : b_[k] * residual[previous_[k]]);
    }
    return z;
}

Eigen::VectorXd Whitener::coloured(const Eigen::VectorXd& white) const {
    Eigen::VectorXd r = Eigen::VectorXd::Zero(white.size());
    for (const Block& block : blocks_) {
        const Eigen::VectorXd own = white(block.rows);
        const Eigen::VectorXd residual = block.factor.matrixL() * own;
        r(block.rows) = residual;
    }
    for (std::size_t k = 0; k < measured_.size(); ++k) {
        if (a_[k] == 0.0) continue;
        const auto i = static_cast<Eigen::Index>(k);
        r[i] = (white[i] + (previous_[k] < 0 ? 0.0 : b_[k] * r[previous_[k]])) / a_[k];
    }
    return r;
}

Noise first_guess(const Problem& p) {
    Noise noise;
    for (const Record& r : p.records) {
        std::vector<ChannelNoise> row;
        for (const Channel& c : r.channels) {
            const double fallback = std::max(0.02 * range_of(c.recorded), 1e-300);
            row.push_back({c.stated_noise > 0.0 ? c.stated_noise : fallback, 0.0});
        }
        noise.push_back(std::move(row));
    }
    return noise;
}

Noise estimated(const Problem& p, const Eigen::VectorXd& residual, std::size_t fitted) {
    std::map<std::string, std::vector<Series>> by_channel;
    std::size_t rows = 0;
    for (std::size_t j = 0; j < p.records.size(); ++j) {
        if (p.records[j].covariance.size() > 0) continue;
        for (std::size_t c = 0; c < p.records[j].channels.size(); ++c) {
            const Channel& channel = p.records[j].channels[c];
            Series s{j, c, {}};
            for (std::size_t k = 0; k < channel.recorded.size(); ++k)
                if (std::isfinite(channel.recorded[k]))
                    s.residual.push_back(residual[static_cast<Eigen::Index>(channel.first + k)]);
            rows += s.residual.size();
            by_channel[p.records[j].experiment->rig + "." + channel.name].push_back(std::move(s));
        }
    }
    const double share_left =
        1.0 - std::min(0.8, static_cast<double>(fitted) /
                                static_cast<double>(std::max<std::size_t>(1, rows)));
    Noise noise = first_guess(p);
    for (const auto& [name, series] : by_channel) {
        std::vector<const Series*> all;
        for (const Series& s : series) all.push_back(&s);
        const double rho = correlation(all, p);
        double pooled = 0.0, pooled_rows = 0.0;
        for (const Series& s : series) {
            for (const double r : s.residual) pooled += r * r;
            pooled_rows += static_cast<double>(s.residual.size());
        }
        for (const Series& s : series) {
            ChannelNoise& n = noise[s.record][s.channel];
            n.correlation = rho;
            if (p.records[s.record].channels[s.channel].stated_noise > 0.0) continue;
            double variance = pooled / std::max(1.0, pooled_rows) / share_left;
            if (s.residual.size() >= long_enough)
                variance = best_variance(upper_spectrum(s.residual), rho);
            n.deviation = std::sqrt(std::max(variance, 1e-300));
        }
    }
    return noise;
}

}  // namespace diagnose
