// SPDX-License-Identifier: MIT
// Results made up by hand, for reports to show; none comes from a simulation.
#pragma once

#include "reports/checks.hpp"
#include "reports/page.hpp"
#include "scaling/scale_study.hpp"

#include <string>

// The zirconia grain of data/zirconia under `scheme`, 0.38 J/m^2 on the scaled grain; weight_bond
// where the scheme is open.
scaling::ScaleStudy zirconia_study(const std::string& scheme);

// Two checks that pass, both pairs of bits equal, heaps that are cones of 30 deg on both sides,
// three seeds each.
reports::Verification cone_verification();

// Whether tags open and close in order; void elements of HTML need no end. The first fault in
// words, or "".
std::string fault_in_markup(const std::string& text);

std::size_t times_in(const std::string& text, const std::string& part);
