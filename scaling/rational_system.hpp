// SPDX-License-Identifier: MIT
// Exact linear algebra over the rationals, for the few unknowns of a scale map and the three rows
// of a dimension matrix.
#pragma once

#include "scaling/dimension.hpp"

#include <optional>
#include <vector>

namespace scaling {

// Exponents of the two generators of every scale factor: factor = h^h * (E'/E)^softening.
struct Exponents {
    Rational h{0}, softening{0};
    friend bool operator==(const Exponents& a, const Exponents& b) {
        return a.h == b.h && a.softening == b.softening;
    }
};

Exponents operator+(const Exponents&, const Exponents&);
Exponents operator-(const Exponents&, const Exponents&);
Exponents operator*(const Rational&, const Exponents&);

using Row = std::vector<Rational>;  // shape [unknowns]
Row operator+(const Row&, const Row&);
Row operator*(const Rational&, const Row&);

// Equations row . x = value, added one by one and kept in reduced echelon form; x are logarithms of
// scale factors.
class RationalSystem {
  public:
    enum class Outcome { added, implied, conflicting };

    // A conflicting equation leaves the system as it was.
    Outcome add(Row row, Exponents value);

    // row . x if the equations so far determine it.
    std::optional<Exponents> value_of(Row row) const;

    std::size_t rank() const { return equations_.size(); }

  private:
    struct Equation {
        std::size_t pivot;
        Row row;  // 1 at the pivot
        Exponents value;
    };
    void reduce(Row& row, Exponents& value) const;
    std::vector<Equation> equations_;
};

// Integer vectors that span {x : sum_k columns[k] x[k] = 0}, one for each column that depends on
// earlier ones: positive there, zero at all other such columns, free of a common divisor. Shapes:
// columns [n][rows], result [n - rank][n].
std::vector<Row> nullspace(const std::vector<Row>& columns);

}  // namespace scaling
