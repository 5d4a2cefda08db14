// SPDX-License-Identifier: MIT
#pragma once

#include "cases/csv.hpp"
#include "diagnose/verdict.hpp"

#include <string>
#include <utility>
#include <vector>

namespace app {

// One table per experiment, in the order of first appearance: ordinate, branch where there is one,
// and of each channel NAME_base and NAME_extended. A row that a channel does not have is NaN there.
std::vector<std::pair<std::string, std::vector<cases::Column>>> prediction_tables(
    const std::vector<diagnose::PredictedCurve>&);

// FOLDER/ID.csv for each experiment. Throws scaling::InvalidInput where a file cannot be written.
void write_predictions(const std::string& folder, const std::vector<diagnose::PredictedCurve>&);

// With those above it. Throws scaling::InvalidInput where it cannot be.
void make_folder(const std::string& folder);

}  // namespace app
