// SPDX-License-Identifier: MIT
// A calibration that has ended, as text, JSON and a page.
#pragma once

#include "calibrate/calibration.hpp"
#include "cases/case.hpp"
#include "reports/json.hpp"
#include "reports/page.hpp"

#include <string>

namespace reports {

// Factors and targets in SI (angles in deg, as `unit` says); every run of the road, and those of fresh seeds.
Json to_json(const calibrate::Calibration&);

std::string text_of(const calibrate::Calibration&);

Verdict verdict_of(const calibrate::Calibration&);

Page page_of(const cases::Case&, const calibrate::Calibration&, const Provenance&);

}  // namespace reports
