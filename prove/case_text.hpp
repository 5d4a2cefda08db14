// SPDX-License-Identifier: MIT
// case.json and recordings as text, and the key.
#pragma once

#include "prove/blind_case.hpp"

#include <map>
#include <string>

namespace prove {

// A value in a unit that people would write: "600 mm". `unit` is SI.
std::string quantity(double si, const std::string& unit);
std::string json_text(const std::string& plain);  // quoted and escaped

// `recordings`: shape of predict() over all experiments. `simulated` likewise, or empty.
std::map<std::string, std::string> case_files(const Skeleton&, const std::string& name,
                                              const std::string& numerics,
                                              const Eigen::VectorXd& recordings,
                                              const Eigen::VectorXd& simulated);
std::string recording_text(const Setup&, const double* values);  // [recorded][ordinates]
std::string experiment_text(const Setup&, const Setup& common,
                            const std::vector<Unknown>& nuisances, int index, bool states_noise,
                            bool simulated);
std::string key_text(const Key&);

}  // namespace prove
