#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the cases of the falling balls from original/. Run it in this folder: python3 convert.py"""
import csv
import json
import math
import os

OUNCE = 28.349523125e-3  # kg, avoirdupois
FRAME = 1.0 / 15.0  # s
# name: (ball in the original, mass in oz, its uncertainty, circumference in cm, its uncertainty, note)
BALLS = {
    "whiffle": ("Whiffle Ball 1", 1.0, 0.29, 22.8, 0.03, "weighed to whole ounces: half an ounce over sqrt(3)"),
    "tennis": ("Tennis Ball", 2.0, 0.04, 20.75, 0.1, "56.0 to 59.4 g in the rules of the game"),
    "golf": ("Golf Ball", 1.62, 0.01, 13.8, 0.03, "1.62 oz is the most that the rules of the game allow"),
    "basketball": ("Blue Basketball", 18.0, 0.29, 75.0, 0.3, "weighed to whole ounces: half an ounce over sqrt(3)"),
    "bowling": ("Bowling Ball", 208.0, 4.0, 68.5, 0.75,
                "of the two entries of the source the one that is a bowling ball: 81 oz is below the lightest made "
                "(6 lb = 96 oz), and 67.0 cm below the rules' 67.8 cm"),
}
WITHOUT_BUOYANCY = ("whiffle",)  # air goes through its holes: what it displaces is its thin shell
SOURCE = ("de Silva, Higdon, Brunton, Kutz (2020) Front. Artif. Intell. 3:25, doi:10.3389/frai.2020.00025. Video at 15 Hz of a drop of "
          "47 m; the ball never reaches z = 0. Height: the first value; release time: the second frame, give or take one. In the "
          "model: gravity 9.79 m/s^2 ({buoyancy}), no drag. Noise is not stated, so it is left to be estimated. Mass: {note}. "
          "Moduli are nominal: nothing is touched. See SOURCE.txt and docs/recordings.md.")


def recordings():
    drops = {}
    with open("original/ball_drops.csv", newline="") as file:
        for row in csv.DictReader(file):
            drops.setdefault((row["ball"], row["drop"]), []).append((row["t_s"], row["height_m"]))
    return drops


def grain(name):
    _, ounces, ounces_error, girth, girth_error, _ = BALLS[name]
    diameter = girth / 100.0 / math.pi
    density = ounces * OUNCE / (math.pi / 6.0 * diameter**3)
    error = density * math.hypot(ounces_error / ounces, 3.0 * girth_error / girth)
    return {"diameter": f"{diameter * 1000:.2f} mm",
            "density": {"value": f"{density:.1f} kg/m^3", "uncertainty": f"{error:.1f} kg/m^3"}}


def experiment(name, drop, rows, role, with_grain):
    made = {"id": f"{name}-{drop}", "rig": "drop"}
    if with_grain:
        made["grain"] = grain(name)
    made["conditions"] = {"height": {"value": f"{float(rows[0][1]):.3f} m", "uncertainty": "0.1 m"},
                          "release_time": {"value": f"{FRAME:.3f} s", "uncertainty": f"{FRAME:.3f} s"}}
    made["recording"] = f"{name}-{drop}.csv"
    made["role"] = role
    return made


def write_case(folder, title, first, buoyancy, note, runs, drops):
    os.makedirs(folder, exist_ok=True)
    experiments = []
    for name, drop, role in runs:
        rows = drops[(BALLS[name][0], drop)]
        with open(f"{folder}/{name}-{drop}.csv", "w", newline="\n") as file:
            file.write("t [s],z [m]\n" + "".join(f"{t},{z}\n" for t, z in rows))
        experiments.append(experiment(name, drop, rows, role, name != first))
    case = {
        "format": "similitude-case/1",
        "title": title,
        "source": SOURCE.format(buoyancy="and buoyancy, known beforehand" if buoyancy else
                                "no buoyancy: a ball with holes displaces its shell only", note=note),
        "grain": {**grain(first), "youngs_modulus": "1 GPa", "poisson_ratio": 0.3},
        "plate": {"youngs_modulus": "10 GPa", "poisson_ratio": 0.2},
        "surroundings": {"gravity": "9.79 m/s^2", "fluid_density": "1.2 kg/m^3", "fluid_viscosity": "1.81e-5 Pa*s"},
        "model": {"physics": ["gravity"] + (["buoyancy"] if buoyancy else []) + ["hertz_mindlin"],
                  "parameters": {"restitution": {"value": 0.7}, "sliding_friction": {"value": 0.3}}},
        "experiments": experiments,
    }
    with open(f"{folder}/case.json", "w", newline="\n") as file:
        json.dump(case, file, indent=1)
        file.write("\n")


def main():
    drops = recordings()
    for name, ball in BALLS.items():
        write_case(name, f"{name} ball, dropped twice from a bridge", name, name not in WITHOUT_BUOYANCY, ball[5],
                   [(name, "1", "fit"), (name, "2", "held_out")], drops)
    write_case("light", "whiffle and tennis ball: one drag coefficient, two weights for a face", "whiffle", False,
               "; ".join(f"{name}: {BALLS[name][5]}" for name in ("whiffle", "tennis")),
               [("whiffle", "1", "fit"), ("tennis", "1", "fit"), ("whiffle", "2", "held_out"), ("tennis", "2", "held_out")], drops)
    write_case("all", "five balls: in no fit, the tennis ball", "whiffle", True,
               "; ".join(f"{name}: {ball[5]}" for name, ball in BALLS.items()),
               [(name, drop, "held_out" if name == "tennis" else "fit") for name in BALLS for drop in ("1", "2")], drops)


main()
