// SPDX-License-Identifier: MIT
// What a design can tell apart, before any response is looked at. X is a model matrix, shape
// [runs][terms]; `names` are its terms.
//   rank X < terms      some combination n of the columns vanishes, X n = 0: fits b and b + c n
//                       have the same residuals for every c, and no data of this design separate
//                       them
//   c'b is estimable    if and only if c'n = 0 for every such n
//   alias matrix        (X'X)^-1 X'Z: what terms Z that are left out of the model add to each b
// Box, Hunter & Hunter (2005), Statistics for Experimenters, 2nd ed., chapter 6; Searle (1971),
// Linear Models, section 5.4.
#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace calibrate {

int rank(const Eigen::MatrixXd& x);

struct NullVector {
    Eigen::VectorXd coefficients;  // [terms]; whole numbers where the columns are, first one > 0
    std::string text;              // "1 - B + D = 0"
};

// A basis of { n : X n = 0 }, by Gauss and Jordan; empty where the rank is full.
std::vector<NullVector> null_vectors(const Eigen::MatrixXd& x,
                                     const std::vector<std::string>& names);

// Whether each term can be estimated by itself. Shape [terms].
std::vector<bool> estimable(const std::vector<NullVector>&, int terms);

// Sums and differences of two terms, neither of them estimable by itself and neither "1", that are:
// "B + G", "B - E".
std::vector<std::string> estimable_pairs(const std::vector<NullVector>&,
                                         const std::vector<std::string>& names);

struct Alias {
    int factor;          // whose main effect
    int first, second;   // carries this two-factor interaction
    double coefficient;  // so many times
    std::string text;    // "A carries -1/3 BC"
};

// Of main effects with two-factor interactions, entries above 1e-9 only. Empty where the linear
// model of `design` has not full rank: then main effects are not even free of each other.
std::vector<Alias> aliases(const Eigen::MatrixXd& design);

// det(X'X)^(1/terms) / runs: 1 for orthogonal two-level designs, 0 where the rank is not full.
double d_efficiency(const Eigen::MatrixXd& x);

// Whether every column is balanced and any two are orthogonal.
bool orthogonal_and_balanced(const Eigen::MatrixXd& design);

}  // namespace calibrate
