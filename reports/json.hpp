// SPDX-License-Identifier: MIT
// Results as JSON: keys in a fixed order, numbers in SI with the digits that give the same double
// again. What is not known is null and has its reason beside it; no NaN and no infinity is ever
// written.
#pragma once

#include "cases/case.hpp"
#include "reports/provenance.hpp"
#include "rigs/drop.hpp"
#include "rigs/flow.hpp"
#include "rigs/measure.hpp"
#include "rigs/pile.hpp"
#include "scaling/scale_study.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace reports {

using Json = nlohmann::ordered_json;

// scheme, h, softening, factors, groups, adhesion, scale_number, cost, findings. What belongs to
// the powder itself stands under "original", what belongs to the simulated one under "scaled".
Json to_json(const scaling::ScaleStudy&);

// The same as the format `similitude-scale/1`: format, case, title and tool stand first.
Json to_json(const cases::Case&, const scaling::ScaleStudy&, double grain_steps_per_second,
             const Provenance&);

// A list of name, value, rule, judgement, text.
Json to_json(const std::vector<scaling::Finding>&);

// angles (rad, by estimator), packing_fraction, coordination, formed with its criteria, counts, the
// hash of the final state.
Json to_json(const rigs::PileRecord&);

// counts, diameters, contacts; heap: null, or formed with its criteria, angles (rad), packing_fraction, profile.
Json to_json(const rigs::Measured&);

// settled and when, impacts, steps.
Json to_json(const rigs::DropRecord&);

// ending, the quantities by name, steps, the hash of the final state.
Json to_json(const rigs::FlowRecord&);

// version, git, compiler, command, case, seeds, threads.
Json to_json(const Provenance&);

// Two spaces of indentation, a newline at the end; bytes that are no UTF-8 are replaced.
std::string text_of(const Json&);

}  // namespace reports
