// SPDX-License-Identifier: MIT
// From a case and what the command line changes of it to the input of scaling/scale_study.hpp.
#pragma once

#include "cases/case.hpp"
#include "scaling/scale_study.hpp"

#include <optional>
#include <string>
#include <vector>

namespace app {

// Empty or missing: as the case has it. Quantities as typed, with their unit.
struct ScaleOverrides {
    std::optional<double> h, softening;
    std::string scheme, invariant;
    std::vector<std::string> keep;  // instead of a named scheme
    bool distorted = false;         // with `keep`: over-determined is accepted
    std::string work_of_adhesion, surface_energy,
        of;                             // one of the two; `of`: "original" or "scaled"
    std::string experiment, apparatus;  // id; a length
};

// Throws scaling::InvalidInput or scaling::InvalidParameter, one line each. A missing invariant is
// asked for where the scheme leaves the adhesion open. The adhesion of a scaled grain that the case
// states belongs to the case's own scaling: where that is overridden, it is first carried back to
// the original grain.
scaling::ScaleInput scale_input(const cases::Case&, const ScaleOverrides&);

// The study of that input; a carried-back adhesion is among its findings. grain_steps_per_second:
// of this machine, > 0.
scaling::ScaleStudy study_of(const cases::Case&, const ScaleOverrides&,
                             double grain_steps_per_second);

// The experiment that `id` names, else the first in an apparatus, else the first at all; nullptr
// where there is none. Throws scaling::InvalidInput for an unknown id.
const cases::Experiment* experiment_of(const cases::Case&, const std::string& id);

}  // namespace app
