// SPDX-License-Identifier: MIT
// The parts of the page as data for its template; only page*.cpp includes this.
#pragma once

#include "reports/page.hpp"

#include <kainjow/mustache.hpp>

#include <string>
#include <vector>

namespace reports {

using kainjow::mustache::data;

// A text that may be missing: false where empty, so that its section is left out.
data optional_text(const std::string&);

// A list and, under "has_NAME", whether there is anything in it.
void set_list(data& object, const std::string& name, data list);

const char* class_of(scaling::Judgement);
const char* class_of(Answer);

// Factors, groups, adhesion, cost, findings; `beside`: another study of the same case, whose groups
// are shown along.
data scale_part(const scaling::ScaleStudy&, const std::optional<scaling::ScaleStudy>& beside);

// Where, hypotheses, effects with their gates, parameters, errors, what would change it, what next.
data diagnosis_part(const diagnose::Verdict&);

data runs_part(const std::vector<RunSection>&);

data checks_part(const std::vector<verify::Check>&);  // by group, in the order of first appearance

data bits_part(const std::vector<verify::BitsCheck>&);

}  // namespace reports
