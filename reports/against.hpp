// SPDX-License-Identifier: MIT
// Our core beside LAMMPS, as a reader meets it: every figure with its bar, and the rules that differ.
#pragma once

#include "reports/json.hpp"
#include "reports/page.hpp"
#include "verify/against_lammps.hpp"

#include <string>

namespace reports {

// no: a figure is outside its bar.
Verdict verdict_of(const verify::AgainstLammps&);

// All of the figures, the differences with their sizes, the heaps seed by seed.
std::string text_of(const verify::AgainstLammps&);
Json to_json(const verify::AgainstLammps&);
Page page_of(const verify::AgainstLammps&, const Provenance&);

}  // namespace reports
