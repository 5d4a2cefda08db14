// SPDX-License-Identifier: MIT
#include "calibrate/audit.hpp"

#include "calibrate/designs.hpp"

#include <cmath>

namespace calibrate {

namespace {

std::vector<EffectFit> fits_of(const Trials& formed, const std::vector<NullVector>& free) {
    if (free.empty()) return {fit_effects(formed)};
    std::vector<EffectFit> fits;
    if (free.size() > 1) return fits;
    for (int k = 1; k < free.front().coefficients.size(); ++k)
        if (free.front().coefficients(k) != 0.0) fits.push_back(fit_effects(formed, k));
    return fits;
}

void add_failed_runs(Audit& a, const AuditInput& input) {
    a.imputed = imputed(input.trials, input.impute);
    a.sign_changes = sign_changes(input.trials);
    a.implied = implied_ranges(input.trials, input.bound);
    const Trials formed = usable(input.trials);
    if (formed.design.rows() > a.rank) {
        const Eigen::VectorXd y = responses_of(formed);
        std::optional<double> prior;
        if (a.rank < a.terms) prior = 0.5 * (y.maxCoeff() - y.minCoeff());
        a.censored = censored_fit(input.trials, input.bound, prior);
    }
    a.feasibility = feasibility(input.trials);
}

}  // namespace

Audit audit(const AuditInput& input) {
    check(input.trials);
    const Trials formed = usable(input.trials);
    const Eigen::MatrixXd planned = model_matrix(input.trials.design, Terms::linear);
    const Eigen::MatrixXd x = model_matrix(formed.design, Terms::linear);
    const std::vector<std::string> names = linear_terms(static_cast<int>(formed.design.cols()));
    Audit a{};
    a.runs = static_cast<int>(planned.rows());
    a.failed = static_cast<int>(planned.rows() - x.rows());
    a.terms = static_cast<int>(x.cols());
    a.planned_rank = rank(planned);
    a.rank = rank(x);
    a.planned_d_efficiency = d_efficiency(planned);
    a.d_efficiency = d_efficiency(x);
    a.planned_orthogonal = orthogonal_and_balanced(input.trials.design);
    a.null_vectors = null_vectors(x, names);
    a.estimable = estimable(a.null_vectors, a.terms);
    a.estimable_pairs = estimable_pairs(a.null_vectors, names);
    a.aliases = aliases(input.trials.design);
    a.means = level_means(formed);
    a.fits = fits_of(formed, a.null_vectors);
    a.variance = analysis_of_variance(formed);
    const int planned_freedom = a.runs - a.terms;
    if (!a.fits.empty() && a.fits.front().degrees_of_freedom > 0 && planned_freedom > 0)
        a.detectable =
            detectable_effect(2.0 * a.fits.front().spread / std::sqrt(a.runs), planned_freedom);
    if (!input.claimed.empty() && !a.fits.empty())
        a.ranking = judged_ranking(input.claimed, a.null_vectors, a.fits);
    if (a.failed > 0) add_failed_runs(a, input);
    return a;
}

}  // namespace calibrate
