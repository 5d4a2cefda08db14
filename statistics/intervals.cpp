// SPDX-License-Identifier: MIT
#include "statistics/intervals.hpp"

#include "scaling/errors.hpp"

#include <boost/math/distributions/students_t.hpp>

#include <cmath>
#include <string>

namespace statistics {

using scaling::InvalidParameter;
using scaling::mistake;

Summary summary(std::span<const double> values) {
    if (values.size() < 2) {
        throw InvalidParameter(mistake("summary.values", std::to_string(values.size()) + " values",
                                       "must be at least 2",
                                       "one repeat has no spread; run another seed"));
    }
    double sum = 0.0;
    for (const double x : values) {
        if (!std::isfinite(x)) {
            throw InvalidParameter(mistake("summary.values", std::to_string(x), "must be finite",
                                           "leave a failed repeat out and report it as failed"));
        }
        sum += x;
    }
    const double n = static_cast<double>(values.size());
    const double mean = sum / n;
    double squares = 0.0;
    for (const double x : values) squares += (x - mean) * (x - mean);
    return {mean, std::sqrt(squares / (n - 1.0)), values.size()};
}

double student_quantile(double p, double degrees_of_freedom) {
    if (!(p > 0.0 && p < 1.0)) {
        throw InvalidParameter(mistake("student_quantile.p", std::to_string(p),
                                       "must lie between 0 and 1, both excluded",
                                       "0.975 belongs to a two-sided 95 % interval"));
    }
    if (!(degrees_of_freedom > 0.0)) {
        throw InvalidParameter(mistake("student_quantile.degrees_of_freedom",
                                       std::to_string(degrees_of_freedom), "must be > 0",
                                       "add repeats"));
    }
    return boost::math::quantile(boost::math::students_t(degrees_of_freedom), p);
}

Interval student_interval(const Summary& s, double confidence) {
    if (!(confidence > 0.0 && confidence < 1.0)) {
        throw InvalidParameter(mistake("student_interval.confidence", std::to_string(confidence),
                                       "must lie between 0 and 1, both excluded", "0.95 is usual"));
    }
    if (s.count < 2 || !(s.standard_deviation >= 0.0)) {
        throw InvalidParameter(mistake(
            "student_interval.summary",
            std::to_string(s.count) + " values with spread " + std::to_string(s.standard_deviation),
            "must be at least 2 values with spread >= 0", "make it by summary(values)"));
    }
    const double n = static_cast<double>(s.count);
    const double half =
        student_quantile(0.5 * (1.0 + confidence), n - 1.0) * s.standard_deviation / std::sqrt(n);
    return {s.mean - half, s.mean + half};
}

}  // namespace statistics
