// SPDX-License-Identifier: MIT
// The map as the format similitude-scaling-map/1 (docs/scaling-map.md), and back.
#pragma once

#include "reports/json.hpp"
#include "verify/scaling_map.hpp"

#include <string>

namespace reports {

Json to_json(const verify::ScalingMap&, const Provenance&);

// Throws scaling::InvalidInput where the file is not of this format; unknown keys are passed over.
verify::ScalingMap read_scaling_map(const std::string& path);

}  // namespace reports
