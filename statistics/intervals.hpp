// SPDX-License-Identifier: MIT
// Mean, spread and Student's interval of independent repeats (seeds, sectors, heaps). Values carry
// the unit of what is measured; every member below is in that unit or dimensionless.
#pragma once

#include <cstddef>
#include <span>

namespace statistics {

struct Summary {
    double mean;
    double standard_deviation;  // of a sample: divisor count - 1; >= 0
    std::size_t count;
};

struct Interval {
    double low, high;
};

// Of `values`, shape [repeats]. Throws scaling::InvalidParameter for fewer than two values or one
// that is not finite.
Summary summary(std::span<const double> values);

// The two-sided interval that holds the true mean with probability `confidence` in (0, 1):
//   mean +- t_{(1 + confidence)/2, count - 1} standard_deviation / sqrt(count)
// "Student" (1908), Biometrika 6, 1, doi:10.1093/biomet/6.1.1. Assumes independent, normal values.
// Throws scaling::InvalidParameter for a confidence outside (0, 1), a count below two or a spread
// below zero.
Interval student_interval(const Summary&, double confidence);

// t_{p, nu}: the value that Student's t with `degrees_of_freedom` nu > 0 stays below with
// probability p in (0, 1).
double student_quantile(double p, double degrees_of_freedom);

}  // namespace statistics
