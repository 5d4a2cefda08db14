// SPDX-License-Identifier: MIT
#include "scaling/rational_system.hpp"

#include <algorithm>
#include <numeric>

namespace scaling {

Exponents operator+(const Exponents& a, const Exponents& b) {
    return {a.h + b.h, a.softening + b.softening};
}

Exponents operator-(const Exponents& a, const Exponents& b) {
    return {a.h - b.h, a.softening - b.softening};
}

Exponents operator*(const Rational& s, const Exponents& a) { return {s * a.h, s * a.softening}; }

Row operator+(const Row& a, const Row& b) {
    Row sum = a;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += b[i];
    return sum;
}

Row operator*(const Rational& s, const Row& a) {
    Row scaled = a;
    for (Rational& entry : scaled) entry *= s;
    return scaled;
}

void RationalSystem::reduce(Row& row, Exponents& value) const {
    for (const Equation& e : equations_) {
        const Rational multiple = row[e.pivot];
        if (is_zero(multiple)) continue;
        row = row + (-multiple) * e.row;
        value = value - multiple * e.value;
    }
}

RationalSystem::Outcome RationalSystem::add(Row row, Exponents value) {
    reduce(row, value);
    const auto pivot =
        std::find_if(row.begin(), row.end(), [](const Rational& r) { return !is_zero(r); });
    if (pivot == row.end()) return value == Exponents{} ? Outcome::implied : Outcome::conflicting;
    const Rational scale = Rational(1) / *pivot;
    const Equation added{static_cast<std::size_t>(pivot - row.begin()), scale * row, scale * value};
    for (Equation& e : equations_) {
        const Rational multiple = e.row[added.pivot];
        e.row = e.row + (-multiple) * added.row;
        e.value = e.value - multiple * added.value;
    }
    equations_.push_back(added);
    return Outcome::added;
}

std::optional<Exponents> RationalSystem::value_of(Row row) const {
    Exponents negative;
    reduce(row, negative);
    if (std::any_of(row.begin(), row.end(), [](const Rational& r) { return !is_zero(r); }))
        return std::nullopt;
    return Exponents{} - negative;
}

namespace {

// The multiple of `v` with integer entries that have no common divisor.
Row as_small_integers(const Row& v) {
    int multiple = 1, divisor = 0;
    for (const Rational& r : v) multiple = std::lcm(multiple, r.denominator());
    for (const Rational& r : v) divisor = std::gcd(divisor, (Rational(multiple) * r).numerator());
    return Rational(multiple, divisor) * v;
}

}  // namespace

std::vector<Row> nullspace(const std::vector<Row>& columns) {
    const std::size_t n = columns.size(), rows = n == 0 ? 0 : columns[0].size();
    // combination[i]: how column i is made of the pivot columns; found by elimination on [column |
    // identity].
    struct Pivot {
        std::size_t row;
        Row column;       // reduced, 1 at `row`
        Row combination;  // of the original columns; shape [n]
    };
    std::vector<Pivot> pivots;
    std::vector<Row> result;
    for (std::size_t k = 0; k < n; ++k) {
        Row column = columns[k], combination(n, Rational(0));
        combination[k] = Rational(1);
        for (const Pivot& p : pivots) {
            const Rational multiple = -column[p.row];
            column = column + multiple * p.column;
            combination = combination + multiple * p.combination;
        }
        std::size_t row = 0;
        while (row < rows && is_zero(column[row])) ++row;
        if (row == rows) {
            result.push_back(as_small_integers(combination));
        } else {
            const Rational scale = Rational(1) / column[row];
            pivots.push_back({row, scale * column, scale * combination});
        }
    }
    return result;
}

}  // namespace scaling
