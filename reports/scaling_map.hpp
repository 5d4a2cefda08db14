// SPDX-License-Identifier: MIT
// The map as a reader meets it: as text, and as a page of coloured tables.
#pragma once

#include "reports/page.hpp"
#include "verify/scaling_map.hpp"

#include <string>

namespace reports {

// yes: all planned heaps are there, whatever the cells say; cannot tell: some are missing.
Verdict verdict_of(const verify::ScalingMap&);

std::string text_of(const verify::ScalingMap&);

// Quantities and rules as a reader knows them: "flank angle, 2h/D angle, packing fraction".
std::string map_words(const std::string& names);

// The cells of a study: rows rules and Bond numbers, columns factors, colour the verdict. With a quantity its difference and
// interval are written in, without one the cell's verdict and what breaks it. Empty where the study has no such cells.
std::string map_svg(const verify::ScalingMap&, const std::string& study,
                    const std::string& quantity, const std::string& id);

Page page_of(const verify::ScalingMap&, const Provenance&);

}  // namespace reports
