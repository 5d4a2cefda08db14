// SPDX-License-Identifier: MIT
// The work of `prove --rig pile`: LAMMPS pours the heaps that the keys rest on and those of the cases, each a file; the judge sees
// the cases (docs/prove-heaps.md). It can be stopped at any time and taken up again.
#pragma once

#include "app/campaign.hpp"

namespace app {

struct HeapCampaign {
    Campaign common;  // extent.kind and extent.rig are not looked at; a shard has whole families
    std::string lammps = "lmp";  // program
    double size = 1.0;           // of the heaps: 1000 times this many grains in the largest
};

// As `work`; `show` hears of heaps first, of cases then.
bool work(const HeapCampaign&,
          const std::function<void(double done, double of, const std::string& name)>& show,
          const std::atomic<bool>& stop);

Result score(const HeapCampaign&);

}  // namespace app
