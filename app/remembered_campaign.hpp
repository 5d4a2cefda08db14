// SPDX-License-Identifier: MIT
#pragma once

#include "app/common.hpp"
#include "app/progress.hpp"
#include "verify/pile_runs.hpp"

#include <filesystem>
#include <string>

namespace app {

// A campaign that an interrupt stops, that shows its progress as `what` ("heaps"), and that remembers in `folder` what is finished;
// without --resume that folder is emptied first.
verify::Campaign remembered_campaign(const CommonOptions&, const std::filesystem::path& folder,
                                     Progress&, const std::string& what);

}  // namespace app
