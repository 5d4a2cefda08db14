// SPDX-License-Identifier: MIT
#include "diagnose/scores.hpp"

#include <algorithm>
#include <cmath>

namespace diagnose {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

double range_of(const Channel& c) {
    double low = 1e300, high = -1e300;
    for (const double v : c.recorded)
        if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
    return high - low;
}

// Of lean and roughness of a heap that of its heights: they are parts of one channel.
double range_of(const Record& r, const Channel& c) {
    return range_of(c.name.starts_with("z_") ? r.channels.front() : c);
}

// 100 rms/(max - min); NaN where the channel never moves.
struct Nrmse {
    double base, extended, floor;
};

Nrmse nrmse_of(const Record& r, const Channel& c, const VectorXd& base, const VectorXd& extended,
               double noise) {
    double b = 0.0, e = 0.0, n = 0.0;
    for (std::size_t k = 0; k < c.recorded.size(); ++k) {
        const double v = c.recorded[k];
        if (!std::isfinite(v)) continue;
        const auto at = static_cast<Index>(c.first + k);
        n += 1.0;
        b += (base[at] - v) * (base[at] - v), e += (extended[at] - v) * (extended[at] - v);
    }
    const double scale = 100.0 / range_of(r, c);
    return {scale * std::sqrt(b / n), scale * std::sqrt(e / n), scale * noise};
}

}  // namespace

Candidate carried_over(const Problem& to, const Candidate& c) {
    Candidate moved{.h = to.hypothesis(c.h.terms), .fit = {}, .log_evidence = c.log_evidence};
    VectorXd theta = start_of(moved.h.unknowns);
    for (std::size_t k = 0; k < moved.h.unknowns.size(); ++k)
        for (std::size_t n = 0; n < c.h.unknowns.size(); ++n)
            if (moved.h.unknowns[k].name == c.h.unknowns[n].name &&
                moved.h.unknowns[k].index == c.h.unknowns[n].index &&
                moved.h.unknowns[k].key == c.h.unknowns[n].key)
                theta[static_cast<Index>(k)] = c.fit.theta[static_cast<Index>(n)];
    moved.fit.theta = theta;
    moved.fit.prediction = predicted(to, moved.h, theta);
    return moved;
}

Scores scores(const Problem& p, const Noise& noise, const Candidate& base,
              const Candidate& extended) {
    Scores s{0.0, 0.0, 0.0, {}};
    double count = 0.0;
    for (std::size_t j = 0; j < p.records.size(); ++j) {
        for (std::size_t c = 0; c < p.records[j].channels.size(); ++c) {
            const Nrmse n = nrmse_of(p.records[j], p.records[j].channels[c], base.fit.prediction,
                                     extended.fit.prediction, noise[j][c].deviation);
            if (!std::isfinite(n.base)) continue;
            s.nrmse_base += n.base, s.nrmse_extended += n.extended, s.noise_floor += n.floor,
                count += 1.0;
        }
        s.experiments.push_back(p.records[j].experiment->id);
    }
    if (count > 0.0) s.nrmse_base /= count, s.nrmse_extended /= count, s.noise_floor /= count;
    return s;
}

std::vector<PredictedCurve> curves(const Problem& p, const Noise& noise, const Candidate& base,
                                   const Candidate& extended, bool held_out) {
    std::vector<PredictedCurve> list;
    for (std::size_t j = 0; j < p.records.size(); ++j) {
        const Record& r = p.records[j];
        for (std::size_t c = 0; c < r.channels.size(); ++c) {
            const Channel& channel = r.channels[c];
            PredictedCurve curve{.experiment = r.experiment->id,
                                 .channel = channel.name,
                                 .unit = unit_of_channel(channel.name),
                                 .held_out = held_out,
                                 .ordinate = r.ordinate,
                                 .ordinate_unit = r.ordinate == "t"       ? "s"
                                                  : r.ordinate == "angle" ? "rad"
                                                                          : "m",
                                 .at = r.ordinates.at,
                                 .branch = {},
                                 .recorded = channel.recorded,
                                 .base = {},
                                 .extended = {},
                                 .noise = noise[j][c].deviation};
            for (const bool retract : r.ordinates.retract)
                curve.branch.push_back(retract ? "retract" : "approach");
            for (std::size_t k = 0; k < channel.recorded.size(); ++k) {
                curve.base.push_back(base.fit.prediction[static_cast<Index>(channel.first + k)]);
                curve.extended.push_back(
                    extended.fit.prediction[static_cast<Index>(channel.first + k)]);
            }
            list.push_back(std::move(curve));
        }
    }
    return list;
}

Noise noise_like(const Problem& to, const Problem& known, const Noise& noise) {
    Noise result = first_guess(to);
    for (std::size_t j = 0; j < to.records.size(); ++j)
        for (std::size_t c = 0; c < to.records[j].channels.size(); ++c) {
            const Channel& channel = to.records[j].channels[c];
            double deviation = 0.0, correlation = 0.0, count = 0.0;
            for (std::size_t a = 0; a < known.records.size(); ++a)
                for (std::size_t b = 0; b < known.records[a].channels.size(); ++b)
                    if (known.records[a].experiment->rig == to.records[j].experiment->rig &&
                        known.records[a].channels[b].name == channel.name)
                        deviation += noise[a][b].deviation, correlation += noise[a][b].correlation,
                            count += 1.0;
            if (count == 0.0) continue;
            result[j][c].correlation = correlation / count;
            if (channel.stated_noise <= 0.0) result[j][c].deviation = deviation / count;
        }
    return result;
}

double log_predictive(const Problem& to, const Noise& noise, const Candidate& c) {
    const Whitener w(to, noise);
    const Candidate moved = carried_over(to, c);
    VectorXd r = to.recorded - moved.fit.prediction;
    for (Index k = 0; k < r.size(); ++k)
        if (!std::isfinite(r[k])) r[k] = 0.0;
    return w.log_normaliser() - 0.5 * w(r).squaredNorm();
}

}  // namespace diagnose
