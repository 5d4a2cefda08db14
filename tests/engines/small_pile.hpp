// SPDX-License-Identifier: MIT
// The small pile that all engines pour in tests.
#pragma once

#include "cases/read_case.hpp"
#include "engines/lammps_run.hpp"
#include "rigs/pile.hpp"
#include "tests/engines/scratch.hpp"

#include <string>

// Grains of 1 mm, m g = 1.284e-5 N, E/(rho g d) = 1e4. `plate`: its two moduli as JSON; `physics`: what is listed beside gravity and
// hertz_mindlin, each with a comma before it.
inline rigs::PileSetup small_pile(const std::string& plate, const std::string& base,
                                  const std::string& physics, int grains) {
    const Scratch folder("small-pile-case");
    const std::string text =
        R"({"format": "similitude-case/1", "title": "t",
  "grain": {"diameter": "1 mm", "density": "2500 kg/m^3", "youngs_modulus": "0.245 MPa", "poisson_ratio": 0.25},
  "plate": )" +
        plate + R"(, "surroundings": {"gravity": "9.81 m/s^2"},
  "model": {"physics": ["gravity", "hertz_mindlin")" +
        physics +
        R"(],
    "parameters": {"restitution": {"value": 0.5}, "sliding_friction": {"value": 0.5},
      "rolling_friction": {"value": 0.1}, "work_of_adhesion": {"value": "0.02 J/m^2"}}},
  "experiments": [{"id": "pile", "rig": "pile", "conditions": {"base": ")" +
        base + R"(", "base_diameter": "8 mm", "grains": )" + std::to_string(grains) + "}}]}";
    engines::write_text(folder.path / "case.json", text);
    const cases::Case c = cases::read_case((folder.path / "case.json").string());
    return rigs::pile_setup(c, c.experiments.front(), 1);
}
