// SPDX-License-Identifier: MIT
// Small cases of the rigs `discharge`, `column` and `drum`: soft beads of 1 mm, so that sqrt(d/g) is some hundred steps.
#pragma once

#include "cases/read_case.hpp"
#include "rigs/flow.hpp"
#include "tests/cases/temporary_case.hpp"

#include <catch2/catch.hpp>

#include <string>

namespace samples {

inline cases::Case flow_case(const std::string& rig, const std::string& conditions,
                             const std::string& recording = "", const std::string& grain = "",
                             const std::string& more = "") {
    const TemporaryFolder folder;
    if (!recording.empty()) folder.write("recording.csv", recording);
    folder.write("case.json", R"({
  "format": "similitude-case/1",
  "grain": {"diameter": "1 mm", "density": "2500 kg/m^3", "youngs_modulus": "0.1 MPa", "poisson_ratio": 0.3)" +
                                  grain + R"(},
  "plate": {"youngs_modulus": "0.1 MPa", "poisson_ratio": 0.3},
  "surroundings": {"gravity": "9.81 m/s^2"},
  "model": {"physics": ["gravity", "hertz_mindlin", "rolling_resistance"],
    "parameters": {"restitution": {"value": 0.5}, "sliding_friction": {"value": 0.5},
                   "rolling_friction": {"value": 0.05}})" +
                                  more + R"(},
  "experiments": [{"id": "one", "rig": ")" +
                                  rig + R"(", "conditions": {)" + conditions + "}" +
                                  (recording.empty() ? "" : R"(, "recording": "recording.csv")") +
                                  "}]}");
    return cases::read_case(folder.path());
}

inline rigs::FlowSetup flow_setup(const std::string& rig, const std::string& conditions,
                                  const std::string& recording = "") {
    const cases::Case c = flow_case(rig, conditions, recording);
    return rigs::flow_setup(c, c.experiments.at(0), 1);
}

inline rigs::FlowRun run_of(const rigs::FlowSetup& setup) {
    rigs::FlowRun run = rigs::begin_flow(setup, 1);
    while (!run.state.finished) rigs::advance(run, setup, 5000);
    return run;
}

inline double quantity(const rigs::FlowRecord& record, const std::string& name) {
    for (const rigs::FlowQuantity& q : record.quantities)
        if (q.name == name) return q.value;
    FAIL("no quantity " << name);
    return 0.0;
}

}  // namespace samples
