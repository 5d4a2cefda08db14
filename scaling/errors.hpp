// SPDX-License-Identifier: MIT
// The two mistakes a user can make. Both carry one line: where, the value with its unit, the rule,
// the remedy.
#pragma once

#include <stdexcept>
#include <string>

namespace scaling {

// A parameter that a law or a solver was handed from code: "Jkr.work_of_adhesion: got -0.05 J/m^2,
// must be > 0 (...)".
struct InvalidParameter : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

// A value in a file or on the command line: "case.json: grain.diameter: got \"-4 mm\", must be > 0
// (...)".
struct InvalidInput : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// `where: got <value>, <rule> (<remedy>)`, the one shape of every message.
std::string mistake(const std::string& where, const std::string& value, const std::string& rule,
                    const std::string& remedy);

}  // namespace scaling
