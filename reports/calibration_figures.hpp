// SPDX-License-Identifier: MIT
// Figures of a replayed calibration. `id` of each is its own.
#pragma once

#include "calibrate/observations.hpp"
#include "reports/runs.hpp"

namespace reports {

// Claimed effects with their intervals, by every fit that the data allow.
Figure effects_figure(const calibrate::Replayed&);

// Claimed effects against the value counted for failed runs.
Figure imputed_figure(const calibrate::Replayed&);

// Responses of the second ascent and of the orthogonal test against the second factor, with the
// line, the target and the range of its readings.
Figure response_figure(const calibrate::Replayed&);

}  // namespace reports
