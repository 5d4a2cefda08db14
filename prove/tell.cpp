// SPDX-License-Identifier: MIT
#include "prove/draft.hpp"
#include "prove/user_run.hpp"

#include <algorithm>
#include <cmath>

namespace prove {
namespace {

// Fastest speed of the grain in the recordings with role fit, by differences of the truth; drag_coefficient is told there.
double curve_at_fastest(const Skeleton& sk, const World& truth) {
    double speed = 0.0, curve = 0.44;
    for (const Setup& s : sk.truth) {
        if (s.held_out) continue;
        const std::vector<double> y = predict(truth, s);
        for (std::size_t k = 1; k < s.at.size(); ++k) {
            double v = std::abs(y[k] - y[k - 1]) / (s.at[k] - s.at[k - 1]);
            if (s.recorded.size() > 1 && s.recorded[1] == Channel::x)
                v = std::hypot(
                    v, (y[s.at.size() + k] - y[s.at.size() + k - 1]) / (s.at[k] - s.at[k - 1]));
            if (v > speed) speed = v, curve = drag_curve(reynolds(s, v));
        }
    }
    return curve;
}

void tell_parameters(Draft& d) {
    const std::vector<std::size_t> list = with_role(d.sk, false);
    std::vector<Unknown> unknowns = base_unknowns(d.sk, list);
    const std::size_t base = unknowns.size();
    for (const Term& t : d.terms)
        unknowns.insert(unknowns.end(), t.unknowns.begin(), t.unknowns.end());
    // The information at the truth; a fit that starts there and has nowhere to go.
    const std::vector<Setup> truth = chosen(d.sk.truth, list);
    const Fit f = fit(d.world, truth, unknowns, d.sk.noise, predict(d.world, truth), 0);
    const Eigen::VectorXd errors = standard_errors(f);
    std::size_t k = base;
    for (const Term& t : d.terms) {
        for (const Unknown& u : t.unknowns) {
            const Eigen::Index at = static_cast<Eigen::Index>(k++);
            const double factor =
                u.name == "drag_coefficient" ? curve_at_fastest(d.sk, d.world) : 1.0;
            std::string unit = unit_of_parameter(u.name);
            if (unit.empty()) unit = unit_of(u.shifted.front());
            d.key.parameters.push_back(
                {t.effect, t.channel, u.name, unit, factor * f.theta[at], factor * errors[at]});
        }
    }
}

void tell_mismatch(Draft& d, const Mismatch& m) {
    Key& k = d.key;
    k.idr = m.idr, k.n_eff = m.n_eff, k.lambda = m.lambda;
    int freedom = 0;
    for (const Term& t : d.terms) freedom += static_cast<int>(t.unknowns.size());
    k.oracle_power = likelihood_ratio_power(m.lambda, std::max(1, freedom));
    k.intervals = true_intervals(d.sk, m);
}

}  // namespace

// The oracle: the true terms, fitted to what was recorded; then the held-out experiments with their stated conditions.
void tell_held_out(Draft& d, const Eigen::VectorXd& recordings) {
    const std::vector<std::size_t> fits = with_role(d.sk, false), held = with_role(d.sk, true);
    std::vector<Unknown> unknowns = base_unknowns(d.sk, fits);
    const std::vector<Unknown> base_only = unknowns;
    for (const Term& t : d.terms)
        unknowns.insert(unknowns.end(), t.unknowns.begin(), t.unknowns.end());
    Eigen::Index split = 0;
    for (const std::size_t e : fits) split += static_cast<Eigen::Index>(d.sk.stated[e].size());
    const Eigen::VectorXd seen = recordings.head(split);
    const Eigen::VectorXd unseen = recordings.tail(recordings.size() - split);
    const std::vector<Setup> later = chosen(d.sk.stated, held);
    // What the user's program would answer, where it is the program that is at fault.
    const auto by = [&](bool user, const std::vector<std::size_t>& list) {
        std::vector<Setup> setups = chosen(d.sk.stated, list);
        for (Setup& s : setups)
            if (user) s.user = d.run;
        return setups;
    };
    const auto fitted = [&](const World& start, const std::vector<Unknown>& list, bool user) {
        return fit(start, by(user, fits), list, d.sk.noise, seen);
    };
    const auto error = [&](const Fit& f, bool user) {
        return mean_nrmse(later, predict(f.world, by(user, held)), unseen);
    };
    const Fit oracle = fitted(d.world, unknowns, false);
    const Fit base = d.run.used ? fitted(d.sk.world, base_only, true) : base_fit(d.sk, fits, seen);
    d.key.oracle_held_out = error(oracle, false);
    d.key.base_held_out = error(base, d.run.used);
    d.key.oracle_statistic = base.cost() - oracle.cost();
    d.key.oracle_freedom = std::max(1, static_cast<int>(unknowns.size() - base_only.size()));
    Eigen::VectorXd floor = unseen;
    Eigen::Index k = 0;
    for (const Setup& s : later)
        for (const double deviation : s.noise)
            for (std::size_t row = 0; row < s.at.size(); ++row) floor[k++] += deviation;
    d.key.noise_floor = mean_nrmse(later, floor, unseen);
}

void name(Draft& d, const Plan& plan, int number) {
    Key& k = d.key;
    k.name = case_name(number);
    k.kind = plan.kind, k.subkind = plan.subkind, k.rig = to_string(plan.rig);
    k.noise = d.sk.noise;
    k.recorded_channels = static_cast<int>(d.sk.stated.front().recorded.size());
    for (const Term& t : d.terms) k.effects.push_back(t.effect), k.channels.push_back(t.channel);
    if (plan.kind == Kind::outside) k.effects = {"unknown"};
    if (plan.kind == Kind::numerical) k.effects = {"numerical_artefact"};
}

void tell(Draft& d, const Plan& plan) {
    Key& k = d.key;
    if (plan.kind == Kind::numerical) {
        tell_mismatch(d, user_mismatch(d.sk, d.run));
        return;
    }
    const Mismatch m = mismatch(d.sk, d.world);
    tell_mismatch(d, m);
    if (plan.kind == Kind::null) {
        k.oracle_power = 0.05;
        k.intervals.clear();
        return;
    }
    if (!d.terms.empty()) tell_parameters(d);
    std::vector<std::string> right;
    for (const Term& t : d.terms) right.push_back(t.effect);
    if (plan.kind != Kind::pair) k.separation = separation(d.sk, d.world, right);
    if (plan.kind == Kind::pair) k.separation = separation(d.sk, d.world, {});
    if (plan.kind == Kind::outside || plan.kind == Kind::pair)
        k.pair_separation = pair_separation(d.sk, d.world, right).d;
}

}  // namespace prove
