// SPDX-License-Identifier: MIT
// A verdict as the scorer sees it: `similitude-verdict/1` of any judge, in SI. Keys read back from their files.
#pragma once

#include "cases/value.hpp"
#include "prove/blind_case.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace prove {

struct Estimate {
    std::string name;
    double value, low, high;  // 90 %
};

struct JudgedEffect {
    std::string name;
    double probability = 0.0;
    bool named = false;
    std::vector<Estimate> parameters{};
};

struct JudgedPlace {
    std::string experiment, channel, variable;
    double from, to;
};

struct Hypothesis {
    std::vector<std::string> effects;  // sorted; empty: none
    double probability;
};

struct Verdict {
    std::string verdict;  // consistent, explained, ambiguous, unexplained, undecided
    std::vector<JudgedPlace> located{};
    std::vector<Hypothesis> hypotheses{};
    std::vector<JudgedEffect> effects{};
    std::optional<double> held_out_extended{};  // nrmse, %
    std::vector<std::string>
        between{};  // hypotheses that the next experiment tells apart, "a" or "a + b"

    bool alarm() const;                      // a mismatch was called
    std::vector<std::string> named() const;  // sorted, "unknown" left out
};

using Verdicts = std::map<std::string, Verdict>;  // by the name of the case
using Keys = std::map<std::string, Key>;

// Throw scaling::InvalidInput where a file is no verdict or no key.
Verdict read_verdict(const std::string& path);
Key read_key(const std::string& path);
// All DIR/case-*.json; a file that is no whole verdict counts as none.
Verdicts read_verdicts(const std::string& directory);
Keys read_keys(const std::string& directory);

// "2.1 m/s" in SI, or a bare number as it is.
double si_value(const cases::Value&);

// The few members that the scorer reads, as `similitude-verdict/1`.
std::string verdict_text(const std::string& case_name, const Verdict&);

}  // namespace prove
