// SPDX-License-Identifier: MIT
// What `bench` measured, as JSON, as text and as sections of the page.
#pragma once

#include "bench/compare.hpp"
#include "bench/machine.hpp"
#include "bench/scaling.hpp"
#include "reports/json.hpp"
#include "reports/runs.hpp"

#include <optional>
#include <string>
#include <vector>

namespace app {

struct BenchResults {
    bench::Machine machine;
    std::optional<bench::Comparison> comparison;
    std::optional<bench::ScalingStudy> scaling;
    std::optional<bench::PolydisperseStudy> polydisperse;
    std::vector<bench::Triad> triads;
};

// machine, bed, engines, runs, ratio (by engine), stream; scaling, polydisperse.
reports::Json to_json(const BenchResults&);

std::string text_of(const BenchResults&);

std::vector<reports::RunSection> sections_of(const BenchResults&);

// The speed of what was compared or, without that, of the largest bed.
reports::Verdict verdict_of(const BenchResults&);

// What such a measurement does not show, a sentence each.
std::vector<std::string> limits_of(const BenchResults&);

}  // namespace app
