// SPDX-License-Identifier: MIT
// A heap measured in a photograph: numbers, words and the picture with what was found drawn over it.
#pragma once

#include "photo/measure.hpp"
#include "reports/json.hpp"
#include "reports/runs.hpp"
#include "reports/verdict.hpp"

#include <optional>
#include <string>
#include <vector>

namespace reports {

struct PhotoScale {
    double metres_per_pixel;
    double relative_error;  // standard, of metres_per_pixel
};

// cannot tell where nothing could be measured; the why is then the finding that forbade it.
Verdict verdict_of(const photo::Measurement&);

// angle_of_repose (rad, estimator silhouette, with interval, flanks and the parts of its uncertainty), two_h_over_d, tilt, height and foot width in
// pixels and, with a scale, in m; findings. Places in pixels of the file turned upright.
Json to_json(const photo::Measurement&, const std::optional<PhotoScale>&);

// The same for a person.
std::string text_of(const photo::Measurement&, const std::optional<PhotoScale>&);

// The picture with the edge, the base line and both flanks.
RunSection photo_section(const std::string& name, const photo::Picture&, const photo::Measurement&,
                         const std::optional<PhotoScale>&);

// What one picture cannot show.
std::vector<std::string> limits_of(const photo::Measurement&);

}  // namespace reports
