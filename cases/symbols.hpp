// SPDX-License-Identifier: MIT
// One symbol of a unit ("mJ", "rpm", "micrometer", "cP"), looked up in udunits2's dictionary. The
// only file pair that sees udunits2.
#pragma once

#include "cases/units.hpp"

#include <optional>
#include <string>

namespace cases {

// Nothing where neither the dictionary nor our short list (deg, P, dyn, bar, rev; grains count as
// 1) has the symbol, with at most one SI prefix, and where it is no mechanical unit or a charge
// (kelvin, mole). Throws std::runtime_error where udunits2's database is not installed.
std::optional<Unit> find_symbol(const std::string& symbol);

}  // namespace cases
