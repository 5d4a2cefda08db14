// SPDX-License-Identifier: MIT
// `calibrate CASE`: its options, what it prints and how it ends.
#pragma once

#include "app/calibration_runs.hpp"
#include "app/common.hpp"

#include <string>

namespace app {

struct CampaignOptions {
    CommonOptions common;
    std::string path;
    RoadOptions road{.out = "out/calibrate"};  // seed, threads and resume are the common ones
};

// All but CASE and the common ones.
void add_campaign_options(CLI::App& verb, CampaignOptions&);

// Returns the exit code.
int calibrate_campaign(const CampaignOptions&, const std::string& command);

}  // namespace app
