// SPDX-License-Identifier: MIT
// Results as plain text for a terminal, 100 columns at most where the words allow it.
#pragma once

#include "scaling/scale_study.hpp"

#include <string>
#include <vector>

namespace reports {

// The whole study: verdict, factors, groups, adhesion with its findings, cost, what does not fit.
std::string text_of(const scaling::ScaleStudy&);

// Columns as wide as they need, two spaces apart; the first row is the heading. Shape
// [rows][columns]; `right` says which columns line up on the right, shape [columns].
std::string columns(const std::vector<std::vector<std::string>>& rows,
                    const std::vector<bool>& right);

// Lines of at most `width` characters, broken at spaces, all but the first indented by `indent`.
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent);

}  // namespace reports
