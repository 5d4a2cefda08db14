// SPDX-License-Identifier: MIT
#include "diagnose/left_out.hpp"

#include <Eigen/Cholesky>

#include <cmath>
#include <vector>

namespace diagnose {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double left_out_misfit(const Problem& p, const Whitener& w, const Hypothesised& h, const Fit& at) {
    constexpr int iterations = 12;
    if (p.records.size() < 2) return std::nan("");
    double sum = 0.0;
    for (std::size_t j = 0; j < p.records.size(); ++j) {
        const VectorXd own_rows = rows_of(p, j, VectorXd::Ones(static_cast<Index>(p.size)));
        const VectorXd others = VectorXd::Ones(own_rows.size()) - own_rows;
        std::vector<Index> own;  // unknowns of this recording alone
        VectorXd u = to_u(h.unknowns, at.theta);
        for (Index k = 0; k < u.size(); ++k)
            if (h.unknowns[static_cast<std::size_t>(k)].experiment == p.records[j].experiment->id)
                own.push_back(k), u[k] = 0.0;
        const Fit f = evaluated(p, w, h, descended(p, w, h, u, iterations, others).theta);
        const VectorXd z = f.white.cwiseProduct(own_rows);
        sum += z.squaredNorm();
        if (own.empty()) continue;
        MatrixXd slopes(z.size(), static_cast<Index>(own.size()));
        for (std::size_t k = 0; k < own.size(); ++k)
            slopes.col(static_cast<Index>(k)) = f.jacobian.col(own[k]).cwiseProduct(own_rows);
        const VectorXd b = slopes.transpose() * z;
        const MatrixXd a = slopes.transpose() * slopes + MatrixXd::Identity(b.size(), b.size());
        sum -= b.dot(a.ldlt().solve(b));
    }
    return sum;
}

}  // namespace diagnose
