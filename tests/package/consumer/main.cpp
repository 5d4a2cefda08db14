// SPDX-License-Identifier: MIT
// A program of somebody else: a unit, a law, a case and its forward model.
#include "cases/read_case.hpp"
#include "cases/units.hpp"
#include "contact/jkr.hpp"
#include "diagnose/diagnose.hpp"
#include "rigs/forward.hpp"

#include <cstdio>

int main(int argc, char** argv) {
    const double w = cases::to_si("0.38 J/m^2", cases::parse_unit("J/m^2", "w"), "w");
    const contact::Jkr law{5e6, w};
    std::printf("%.6g N\n", law.pull_off_force(60e-6));
    const cases::Case c = cases::read_case(argc > 1 ? argv[1] : "");
    std::printf("%zu experiments\n", c.experiments.size());
    const diagnose::Verdict v = diagnose::diagnose(c, {}, [](cases::Case&) {});
    return v.answer == diagnose::Answer::explained ? 0 : 1;
}
