// SPDX-License-Identifier: MIT
// Spheres that roll without slip down a plane, s = 5/14 g sin(angle) t^2, in closed form.
#pragma once

#include "verdicts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <sstream>
#include <string>

// Three slopes, 60 rows of 1 s each, noise 0.3 mm. The plane leans by `lean` (rad) more than the case says, and the instrument adds
// `added(t)` m to s: the model knows of neither.
template <class Added>
cases::Case rolled(double lean, const Added& added) {
    std::map<std::string, std::string> files;
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal(0.0, 3e-4);
    std::string experiments;
    for (const int slope : {8, 14, 20}) {
        std::ostringstream table;
        table << "t [s],s [m]\n";
        const double angle = slope * std::numbers::pi / 180.0 + lean;
        for (int row = 1; row <= 60; ++row) {
            const double t = row / 60.0;
            table << t << ','
                  << 5.0 / 14.0 * 9.81 * std::sin(angle) * t * t + added(t) + normal(random)
                  << '\n';
        }
        const std::string id = fmt::format("slope-{}", slope);
        files[id + ".csv"] = table.str();
        if (!experiments.empty()) experiments += ',';
        experiments += fmt::format(R"({{"id": "{0}", "rig": "incline", "conditions":
  {{"angle": "{1} deg"}}, "recording": "{0}.csv", "noise": {{"s": "0.3 mm"}}, "role": "fit"}})",
                                   id, slope);
    }
    files["case.json"] = R"({"format": "similitude-case/1", "title": "rolled",
  "grain": {"diameter": "4 mm", "density": "2500 kg/m^3", "youngs_modulus": "60 GPa", "poisson_ratio": 0.22},
  "plate": {"youngs_modulus": "60 GPa", "poisson_ratio": 0.22},
  "surroundings": {"gravity": "9.81 m/s^2"},
  "model": {"physics": ["gravity", "hertz_mindlin"],
            "parameters": {"sliding_friction": {"value": 0.4, "range": [0.3, 0.6]}}},
  "experiments": [)" + experiments +
                         "]}\n";
    return case_of(files);
}
