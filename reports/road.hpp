// SPDX-License-Identifier: MIT
// A calibration that has ended, as text, JSON and a page.
#pragma once

#include "calibrate/calibration.hpp"
#include "cases/case.hpp"
#include "reports/json.hpp"
#include "reports/page.hpp"

#include <string>

namespace reports {

// Format similitude-calibration/1: factors and targets (angles in deg, heights in mm, all else in SI, as `unit` says), answer, every run.
Json to_json(const calibrate::Calibration&, const Provenance&);

std::string text_of(const calibrate::Calibration&);

Verdict verdict_of(const calibrate::Calibration&);

Page page_of(const cases::Case&, const calibrate::Calibration&, const Provenance&);

}  // namespace reports
