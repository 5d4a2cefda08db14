// SPDX-License-Identifier: MIT
// Designs of experiments. Every design is a matrix of shape [runs][factors] in coded units: -1 is
// the low level, +1 the high level, 0 the middle; only the axial runs of central_composite() leave
// [-1, +1]. Factors are named A, B, C ... in the order of the columns; the letter I is left out, it
// is the identity. All throw scaling::InvalidParameter for sizes that no such design has.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace calibrate {

// A, B ... H, J ... Z for 0 <= factor < 25.
char factor_letter(int factor);

// All combinations of `levels` evenly spaced levels in Yates' order: the first column changes
// fastest. Shape [levels^factors][factors].
Eigen::MatrixXd full_factorial(int factors, int levels = 2);

// A two-level fraction: the first factors - generators columns are a full factorial, each generator
// gives the next column as a product of those, such as "D=ABC" or "E=-AB". Box, Hunter & Hunter
// (2005), Statistics for Experimenters, 2nd ed., chapter 6.
Eigen::MatrixXd fractional_factorial(int factors, const std::vector<std::string>& generators);

// Shape [runs][runs - 1] for 8, 12, 16, 20, 24 or 36 runs: the first row of the published table,
// shifted cyclically runs - 2 times, and a last row of low levels. Plackett & Burman (1946),
// Biometrika 33, 305, doi:10.1093/biomet/33.4.305.
Eigen::MatrixXd plackett_burman(int runs);

// Taguchi's L9 (3^4), L18 (2^1 3^7; its first column has the two levels -1 and +1) and L27 (3^13).
// Taguchi (1987), System of Experimental Design, UNIPUB/Kraus. Any two columns hold each pair of
// levels equally often.
Eigen::MatrixXd orthogonal_array(int runs);

// Full two-level factorial, two axial runs at -alpha and +alpha of each factor, centre runs. The
// design is rotatable for alpha = 2^(factors/4). Box & Wilson (1951), J. R. Stat. Soc. B 13, 1.
Eigen::MatrixXd central_composite(int factors, double alpha, int centre_runs);

// One run in each of `runs` equal slices of every factor, at a random place in the slice. The same
// seed gives the same bits everywhere. McKay, Beckman & Conover (1979), Technometrics 21, 239.
Eigen::MatrixXd latin_hypercube(int runs, int factors, std::uint64_t seed);

// The first runs of Sobol's sequence in up to 40 factors, in GSL's ordering (Antonov & Saleev
// 1979): the first run is the centre.
Eigen::MatrixXd sobol(int runs, int factors);

// The terms of a polynomial in coded units. linear: 1, A, B ...; interactions: and AB, AC ...;
// quadratic: and A^2, B^2 ...
enum class Terms { linear, interactions, quadratic };

// Shape [runs][terms], in the order above: what least squares calls X.
Eigen::MatrixXd model_matrix(const Eigen::MatrixXd& design, Terms);

// `runs` rows of `candidates` (shape [candidates][factors]; a row may repeat) that make det(X'X) of
// the terms as large as exchanges of one row can, from 20 random starts. Modified exchange of Cook
// & Nachtsheim (1980), Technometrics 22, 315, after Fedorov (1972). The exchange finds a maximum
// that no single swap betters; the largest of all is not proved. Throws where no choice makes X'X
// regular.
Eigen::MatrixXd d_optimal(const Eigen::MatrixXd& candidates, Terms terms, int runs,
                          std::uint64_t seed);

// The design and the same runs with every sign changed. Main effects are then free of two-factor
// interactions whatever the design was. Shape [2 runs][factors].
Eigen::MatrixXd fold_over(const Eigen::MatrixXd& design);

}  // namespace calibrate
