// SPDX-License-Identifier: MIT
#include "calibrate/trials.hpp"

#include "calibrate/designs.hpp"
#include "scaling/errors.hpp"

#include <cmath>

namespace calibrate {

namespace {

Eigen::MatrixXd rows_where(const Trials& trials, bool with_response) {
    std::vector<int> rows;
    for (int run = 0; run < trials.design.rows(); ++run) {
        if (trials.responses[static_cast<std::size_t>(run)].has_value() == with_response)
            rows.push_back(run);
    }
    return trials.design(rows, Eigen::all);
}

}  // namespace

Trials usable(const Trials& trials) {
    Trials kept{rows_where(trials, true), {}};
    for (const std::optional<double>& y : trials.responses)
        if (y) kept.responses.push_back(y);
    return kept;
}

Eigen::MatrixXd failed_design(const Trials& trials) { return rows_where(trials, false); }

Eigen::VectorXd responses_of(const Trials& trials) {
    Eigen::VectorXd y(trials.design.rows());
    for (int run = 0; run < y.size(); ++run)
        y(run) = trials.responses[static_cast<std::size_t>(run)].value();
    return y;
}

std::vector<std::string> linear_terms(int factors) {
    std::vector<std::string> terms{"1"};
    for (int k = 0; k < factors; ++k) terms.emplace_back(1, factor_letter(k));
    return terms;
}

void check(const Trials& trials) {
    const auto refuse = [](const std::string& value, const std::string& rule,
                           const std::string& remedy) {
        throw scaling::InvalidParameter(scaling::mistake("trials", value, rule, remedy));
    };
    if (trials.design.rows() != static_cast<Eigen::Index>(trials.responses.size()))
        refuse(std::to_string(trials.responses.size()) + " responses for " +
                   std::to_string(trials.design.rows()) + " runs",
               "must be one for each run", "give a failed run an empty response");
    if (!trials.design.allFinite())
        refuse("a level that is not finite", "must be coded levels", "see designs.hpp");
    for (const std::optional<double>& y : trials.responses)
        if (y && !std::isfinite(*y))
            refuse("a response that is not finite", "must be a number or empty",
                   "a failed run has none");
}

}  // namespace calibrate
