// SPDX-License-Identifier: MIT
// A case that holds one of everything, for tests to change.
#pragma once

#include <string>

inline const std::string sample_recording = "t [s],z [mm]\n0,600\n0.1,551\n";

inline const std::string sample_case = R"({
  "format": "similitude-case/1",
  "title": "polystyrene bead on a steel plate",
  "source": "written for this test",
  "grain": {"diameter": {"value": "4 mm", "uncertainty": "0.1 mm"}, "density": "28 kg/m^3", "youngs_modulus": "3 GPa",
            "poisson_ratio": 0.3, "size_distribution": [["10 %", "3 mm"], [0.5, "4 mm"], ["90 %", "5 mm"]]},
  "plate": {"youngs_modulus": "200 GPa", "poisson_ratio": 0.28},
  "surroundings": {"gravity": "9.81 m/s^2", "fluid_density": "1.204 kg/m^3", "fluid_viscosity": "1.81e-5 Pa*s"},
  "model": {
    "physics": ["gravity", "hertz_mindlin", "adhesion"],
    "parameters": {
      "restitution": {"value": 0.7, "range": [0.2, 0.98]},
      "sliding_friction": {"value": 0.3},
      "work_of_adhesion": {"value": "50 mJ/m^2", "range": ["10 mJ/m^2", "0.1 J/m^2"]}
    },
    "numerics": {"time_step": "1 us", "integrator": "verlet", "youngs_modulus_factor": 0.01}
  },
  "experiments": [
    {"id": "drop-1", "rig": "drop", "conditions": {"height": "600 mm"}, "recording": "drop-1.csv",
     "noise": {"z": "1.5 mm"}, "role": "fit"},
    {"id": "drop-2", "rig": "drop", "conditions": {"height": {"value": "1200 mm", "uncertainty": "2 mm"}, "spin": "60 rpm"},
     "grain": {"diameter": "6 mm"}, "role": "held_out"}
  ],
  "scaling": {"h": 200, "scheme": "paper", "invariant": "weight_bond", "softening": 0.5}
})";
