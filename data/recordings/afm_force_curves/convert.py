#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the two cases from original/. Run it in this folder: python3 convert.py"""
import csv
import json
import os

EVERY = 5  # rows kept: neighbours 3.3 nm apart say the same, the ripple of the base line is 500 nm long
SOURCE_2020 = (
    "AFM-analysis/afmformats, test data (MIT). One curve on an unknown soft sample: the drive z rises towards it; displacement = largest z "
    "- z, so it falls on approach; every 5th row. The file states z and force. It does not state the cantilever's stiffness (11 N/m is the slope of "
    "the first 100 nm of the way back, where drive and deflection move alike), the radius of the tip and the moduli. Diameter and "
    "Young's modulus are stand-ins with a large uncertainty, whose E* sqrt(R) is that of the approach: a pull-off FORCE can be read from "
    "this curve, a work of adhesion cannot. The soft body stands as `grain`, the hard one as `plate`: only E* and R* act. Zero of the drive: where the "
    "approach leaves the ripple of its base line. See docs/recordings.md.")
SOURCE_2018 = ("AFM-analysis/afmformats, test data (MIT). The deflection is in volts of the photodiode, and neither the deflection "
               "sensitivity (nm/V) nor the spring constant (N/m) is stated: this case has to be refused.")


def curve(name):
    """[(z, force)] of the way there and of the way back, as written."""
    with open(name, newline="") as file:
        rows = list(csv.reader(file))
    first = next(i for i, row in enumerate(rows) if row and row[0].startswith("Extend")) + 1
    rows = [[cell.strip() for cell in row] for row in rows[first:] if row]
    return [(r[0], r[1]) for r in rows], [(r[2], r[3]) for r in rows]


def write_recording(name, unit, there, back):
    largest = max(float(z) for z, _ in there + back)
    with open(name, "w", newline="\n") as file:
        file.write(f"displacement [nm],force [{unit}],branch\n")
        for branch, points in (("approach", there), ("retract", back)):
            for z, force in points[::EVERY]:
                file.write(f"{largest - float(z):.4f},{force},{branch}\n")


def case(folder, title, source, conditions):
    made = {
        "format": "similitude-case/1",
        "title": title,
        "source": source,
        "grain": {"diameter": {"value": "10 um", "uncertainty": "3 um"}, "density": "1000 kg/m^3",
                  "youngs_modulus": {"value": "0.34 MPa", "uncertainty": "0.11 MPa"}, "poisson_ratio": 0.49},
        "plate": {"youngs_modulus": "160 GPa", "poisson_ratio": 0.27},
        "model": {"physics": ["hertz_mindlin"], "parameters": {}},
        "experiments": [{"id": "curve-1", "rig": "pull_off", "conditions": conditions, "recording": "curve-1.csv", "role": "fit"}],
    }
    with open(f"{folder}/case.json", "w", newline="\n") as file:
        json.dump(made, file, indent=1)
        file.write("\n")


def main():
    for folder, stamp, unit in (("2020", "2020-02-14_13.41.25", "nN"), ("2018", "2018-08-01_13.06.09", "V")):
        os.makedirs(folder, exist_ok=True)
        there, back = curve(f"original/fmt-afm-workshop-fd_single_{stamp}.csv")
        write_recording(f"{folder}/curve-1.csv", unit, there, back)
    case("2020", "force curve on a soft, sticky sample, behind a cantilever", SOURCE_2020,
         {"counterpart": "plate", "preload": {"value": "2970 nN", "uncertainty": "30 nN"},
          "cantilever_stiffness": {"value": "11 N/m", "uncertainty": "1 N/m"},
          "contact_displacement": {"value": "1980 nm", "uncertainty": "150 nm"}})
    case("2018", "force curve in volts: a force cannot be had from it", SOURCE_2018, {"counterpart": "plate", "preload": "0 N"})


main()
