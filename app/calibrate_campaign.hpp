// SPDX-License-Identifier: MIT
// `calibrate CASE`: the runs that a road asks for, poured side by side, each remembered as soon as it has ended.
#pragma once

#include "app/common.hpp"
#include "app/heaps_engine.hpp"

#include <string>

namespace app {

struct CampaignOptions {
    CommonOptions common;
    std::string path, experiment, out = "out/calibrate";
    std::string road = "surrogate", estimator;  // estimator empty: the recording's
    bool bulk_density = false, yes = false;
    HeapsEngine heaps;
    int budget = 34;  // runs of the surrogate's road; the paper's road makes those that it has
    int batch =
        2;  // runs that the surrogate's road decides on together; not the number of threads: that changes no answer
    int confirm = 6;  // heaps of fresh seeds at the answer, on top
};

// All but CASE and the common ones.
void add_campaign_options(CLI::App& verb, CampaignOptions&);

// Returns the exit code.
int calibrate_campaign(const CampaignOptions&, const std::string& command);

}  // namespace app
