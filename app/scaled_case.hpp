// SPDX-License-Identifier: MIT
// A case with its grains h times as large in the same apparatus, as a case.json that every verb reads.
#pragma once

#include "cases/case.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace app {

struct GrainChange {
    double h, softening;          // scaled over original: diameter, modulus
    double work_of_adhesion = 0;  // J/m^2, of the scaled grain; 0: none
};

struct ScaledCase {
    std::string json;                // the text of case.json
    std::vector<std::string> notes;  // what had to be changed beside the grain
};

// The grain, its sizes and moduli; one experiment of the rig `pile`, its apparatus kept, its count of grains by h^3 (or, where
// it feeds until it spills, 1.5 times a heap of 45 deg that is half solid), and no recordings. A funnel whose outlet is less than
// 10 scaled grains wide would jam: a disc as wide, at its height, feeds instead. Larger grains of one size get the sizes of the
// map's, as much of them in all. Throws scaling::InvalidInput for several
// materials and for an experiment with a grain of its own.
ScaledCase scaled_case(const cases::Case&, const cases::Experiment&, const GrainChange&);

// The file's folder is made. Returns the path of case.json.
std::string write_case(const ScaledCase&, const std::filesystem::path& folder);

}  // namespace app
