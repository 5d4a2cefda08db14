#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes case.json and its recordings from original/. Run it in this folder: python3 convert.py"""
import csv
import json

# quantity of the original: channel, unit, noise, role. The noise is what the three quantities contradict each other by
# (docs/recordings.md); two digitisations of the figure differ by less, 0.2 deg and 0.3 %.
QUANTITIES = {
    "tangential_restitution": ("tangential_restitution", "", 0.015, "fit"),
    "rebound_angle_deg": ("rebound_angle", "deg", "0.4 deg", "fit"),
    "rebound_spin_rad_s": ("rebound_spin", "rad/s", "20 rad/s", "held_out"),
}
SOURCE = ("Kharaz, Gorham, Salman (2001) Powder Technology 120:281-291, doi:10.1016/S0032-5910(01)00283-2: 5 mm aluminium-oxide "
          "sphere on a thick soda-lime glass anvil, 3.9 m/s; as digitised for Lethe's example. Material constants, restitution 0.98 "
          "and the friction of 0.092 that the fit may find (it starts at 0.12): Chung and Ooi (2011), test 4, as Lethe, MFIX (DEM05) and Yade use them. "
          "Noise: what the three quantities contradict each other by; digitising gave 0.2 deg and 0.3 %. Each quantity has its own angles, hence its own experiment; the spin is held out. See "
          "SOURCE.txt and docs/recordings.md.")


def main():
    rows = {name: [] for name in QUANTITIES}
    with open("original/oblique_impact.csv", newline="") as file:
        for row in csv.DictReader(file):
            rows[row["quantity"]].append((row["impact_angle_deg"], row["value"]))
    experiments = []
    for name, (channel, unit, noise, role) in QUANTITIES.items():
        header = f"angle [deg],{channel}" + (f" [{unit}]" if unit else "")
        with open(f"{channel}.csv", "w", newline="\n") as file:
            file.write(header + "\n" + "".join(f"{a},{v}\n" for a, v in rows[name]))
        experiments.append({"id": channel, "rig": "impact", "conditions": {"speed": "3.9 m/s"},
                            "recording": f"{channel}.csv", "noise": {channel: noise}, "role": role})
    case = {
        "format": "similitude-case/1",
        "title": "aluminium-oxide sphere thrown at glass under many angles",
        "source": SOURCE,
        "grain": {"diameter": "5 mm", "density": "4000 kg/m^3", "youngs_modulus": "380 GPa", "poisson_ratio": 0.23},
        "plate": {"youngs_modulus": "70 GPa", "poisson_ratio": 0.25},
        "surroundings": {"gravity": "9.81 m/s^2"},
        "model": {"physics": ["hertz_coulomb"],
                  "parameters": {"restitution": {"value": 0.98, "range": [0.9, 1.0]},
                                 "sliding_friction": {"value": 0.12, "range": [0.05, 0.3]}}},
        "experiments": experiments,
    }
    with open("case.json", "w", newline="\n") as file:
        json.dump(case, file, indent=1)
        file.write("\n")


main()
