// SPDX-License-Identifier: MIT
#include "calibrate/audit.hpp"

#include "calibrate/designs.hpp"

#include <catch2/catch.hpp>

using namespace calibrate;

namespace {

// Effects of A, B, C as given, and a residual of +-1 that no main effect of the 16 runs carries.
Audit of_effects(double a, double b, double c, const std::vector<std::string>& claimed) {
    Trials t{full_factorial(4), {}};
    for (int run = 0; run < 16; ++run) {
        const auto x = t.design.row(run);
        t.responses.emplace_back(30.0 + 0.5 * (a * x(0) + b * x(1) + c * x(2)) +
                                 x(0) * x(1) * x(2) * x(3));
    }
    return audit({t, claimed, {}, 0.0});
}

}  // namespace

// s^2 = 16/11, se = 2 s / 4 = 0.603, t_{0.975, 11} = 2.201 of any table: an effect needs 1.33, a
// difference of two 1.88.
TEST_CASE("ranking: holds where effects differ from zero and from each other",
          "[calibrate][ranking]") {
    CHECK(of_effects(9.0, 6.0, 3.0, {"A", "B", "C"}).ranking.identifiable);
    const Ranking near = of_effects(9.0, 8.0, 3.0, {"A", "B", "C"}).ranking;
    CHECK_FALSE(near.identifiable);
    CHECK(near.why == "A is not larger than B at 95 %");
    const Ranking small = of_effects(9.0, 6.0, 1.0, {"A", "B", "C"}).ranking;
    CHECK_FALSE(small.identifiable);
    CHECK(small.why == "C does not differ from zero at 95 %");
    CHECK(of_effects(9.0, 6.0, 1.0, {"A", "B"}).ranking.identifiable);
}

TEST_CASE("audit: what a run short of full rank leaves open is said, not guessed",
          "[calibrate][audit]") {
    // Half of a 2^3 in which A = B = C: two combinations are free.
    Trials t{Eigen::MatrixXd(4, 3), {1.0, 2.0, 1.5, 2.5}};
    t.design << -1, -1, -1, 1, 1, 1, -1, -1, -1, 1, 1, 1;
    const Audit a = audit({t, {"A", "B"}, {}, 0.0});
    CHECK(a.null_vectors.size() == 2);
    CHECK(a.fits.empty());
    CHECK_FALSE(a.ranking.identifiable);
    CHECK(a.ranking.why == "A, B cannot be told apart, since A - B = 0");
}

TEST_CASE("audit: a saturated design has no degree of freedom to judge by", "[calibrate][audit]") {
    const Trials t{fractional_factorial(3, {"C=AB"}), {1.0, 2.0, 3.0, 5.0}};
    const Audit a = audit({t, {"B"}, {}, 0.0});
    CHECK(a.rank == 4);
    CHECK(a.detectable == 0.0);
    CHECK_FALSE(a.ranking.identifiable);
    CHECK(a.ranking.why == "no degree of freedom is left to judge by");
}
