// SPDX-License-Identifier: MIT
#include "calibrate/identifiability.hpp"

#include "calibrate/designs.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <fmt/format.h>

#include <cmath>

namespace calibrate {

namespace {

constexpr double zero = 1e-9;  // of coded levels, which are of order 1

// "+ 2 B", "- 1/3 AC": a coefficient as a small fraction where it is one.
std::string magnitude(double value) {
    for (int below = 1; below <= 12; ++below) {
        const double above = std::abs(value) * below;
        if (std::abs(above - std::round(above)) > zero) continue;
        const int whole = static_cast<int>(std::round(above));
        if (below > 1) return fmt::format("{}/{} ", whole, below);
        return whole == 1 ? "" : fmt::format("{} ", whole);
    }
    return fmt::format("{:.4g} ", std::abs(value));
}

// The smallest whole numbers in the same ratios, where twelfths are enough; the first one > 0.
Eigen::VectorXd tidy(Eigen::VectorXd n) {
    Eigen::Index first = 0;
    while (std::abs(n(first)) < zero) ++first;
    n /= n(first);
    for (int factor = 1; factor <= 12; ++factor) {
        const Eigen::ArrayXd scaled = factor * n.array();
        if ((scaled - scaled.round()).abs().maxCoeff() < zero) return scaled.round();
    }
    return n;
}

std::string equation(const Eigen::VectorXd& n, const std::vector<std::string>& names) {
    std::string text;
    for (Eigen::Index k = 0; k < n.size(); ++k) {
        if (std::abs(n(k)) < zero) continue;
        const char* sign = n(k) < 0.0 ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + ");
        text += sign + magnitude(n(k)) + names[static_cast<std::size_t>(k)];
    }
    return text + " = 0";
}

struct Reduced {
    Eigen::MatrixXd rows;     // reduced row echelon form
    std::vector<int> pivots;  // column of each row's leading 1
};

Reduced reduced(Eigen::MatrixXd m) {
    Reduced r;
    Eigen::Index row = 0;
    for (int column = 0; column < m.cols() && row < m.rows(); ++column) {
        Eigen::Index pivot = 0;
        const Eigen::Index below = m.rows() - row;
        if (m.col(column).tail(below).cwiseAbs().maxCoeff(&pivot) < zero) continue;
        m.row(row).swap(m.row(row + pivot));
        m.row(row) /= m(row, column);
        for (Eigen::Index other = 0; other < m.rows(); ++other)
            if (other != row) m.row(other) -= m(other, column) * m.row(row);
        r.pivots.push_back(column);
        ++row;
    }
    r.rows = m.topRows(row);
    return r;
}

}  // namespace

int rank(const Eigen::MatrixXd& x) { return static_cast<int>(reduced(x).pivots.size()); }

std::vector<NullVector> null_vectors(const Eigen::MatrixXd& x,
                                     const std::vector<std::string>& names) {
    const Reduced r = reduced(x);
    std::vector<NullVector> basis;
    std::size_t next = 0;
    for (int column = 0; column < x.cols(); ++column) {
        if (next < r.pivots.size() && r.pivots[next] == column) {
            ++next;
            continue;
        }
        Eigen::VectorXd n = Eigen::VectorXd::Zero(x.cols());
        n(column) = 1.0;
        for (std::size_t k = 0; k < r.pivots.size(); ++k)
            n(r.pivots[k]) = -r.rows(static_cast<Eigen::Index>(k), column);
        n = tidy(n);
        basis.push_back({n, equation(n, names)});
    }
    return basis;
}

std::vector<bool> estimable(const std::vector<NullVector>& basis, int terms) {
    std::vector<bool> able(static_cast<std::size_t>(terms), true);
    for (const NullVector& n : basis) {
        for (int k = 0; k < terms; ++k)
            if (std::abs(n.coefficients(k)) > zero) able[static_cast<std::size_t>(k)] = false;
    }
    return able;
}

std::vector<std::string> estimable_pairs(const std::vector<NullVector>& basis,
                                         const std::vector<std::string>& names) {
    const std::vector<bool> alone = estimable(basis, static_cast<int>(names.size()));
    std::vector<std::string> pairs;
    for (std::size_t i = 1; i < names.size(); ++i) {
        for (std::size_t j = i + 1; j < names.size(); ++j) {
            if (alone[i] || alone[j]) continue;
            for (const double sign : {1.0, -1.0}) {
                bool vanishes = true;
                for (const NullVector& n : basis) {
                    const double product = n.coefficients(static_cast<Eigen::Index>(i)) +
                                           sign * n.coefficients(static_cast<Eigen::Index>(j));
                    vanishes = vanishes && std::abs(product) < zero;
                }
                if (vanishes) pairs.push_back(names[i] + (sign > 0 ? " + " : " - ") + names[j]);
            }
        }
    }
    return pairs;
}

std::vector<Alias> aliases(const Eigen::MatrixXd& design) {
    const Eigen::Index k = design.cols();
    const Eigen::MatrixXd x = model_matrix(design, Terms::linear);
    if (rank(x) < x.cols()) return {};
    const Eigen::MatrixXd z = model_matrix(design, Terms::interactions).rightCols(k * (k - 1) / 2);
    const Eigen::MatrixXd a = (x.transpose() * x).ldlt().solve(x.transpose() * z);
    std::vector<Alias> list;
    for (int factor = 0; factor < k; ++factor) {
        Eigen::Index column = 0;
        for (int i = 0; i < k; ++i) {
            for (int j = i + 1; j < k; ++j, ++column) {
                const double c = a(1 + factor, column);
                if (std::abs(c) < zero) continue;
                list.push_back(
                    {factor, i, j, c,
                     fmt::format("{} carries {}{}{}{}", factor_letter(factor), c < 0 ? "-" : "+",
                                 magnitude(c), factor_letter(i), factor_letter(j))});
            }
        }
    }
    return list;
}

double d_efficiency(const Eigen::MatrixXd& x) {
    if (rank(x) < x.cols()) return 0.0;
    const double det = (x.transpose() * x).determinant();
    return std::pow(det, 1.0 / static_cast<double>(x.cols())) / static_cast<double>(x.rows());
}

bool orthogonal_and_balanced(const Eigen::MatrixXd& design) {
    const Eigen::MatrixXd x = model_matrix(design, Terms::linear);
    Eigen::MatrixXd products = x.transpose() * x;
    products.diagonal().setZero();
    return products.cwiseAbs().maxCoeff() < zero;
}

}  // namespace calibrate
