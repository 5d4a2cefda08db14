// SPDX-License-Identifier: MIT
#pragma once

#include "app/common.hpp"
#include "diagnose/diagnose.hpp"

#include <functional>

namespace app {

// Has the signature of diagnose::diagnose.
using Judge = std::function<diagnose::Verdict(const cases::Case&, const diagnose::Settings&,
                                              const std::function<void(cases::Case&)>&)>;

// `diagnose CASE`: which physics was left out. Exit 0 consistent, 3 explained or unexplained, 4
// ambiguous or undecided, 130 where a signal came. What is held out stays sealed until the judge
// opens it.
Verb diagnose_verb(CLI::App& app, const std::string& command, const Judge&);

}  // namespace app
