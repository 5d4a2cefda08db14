#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Recordings of examples/transfer from runs of examples/transfer/truth: noise is added, scans are thinned out. The heaps are
LAMMPS'; its force curves tear off at the deepest tension, those of the tool at the fold, as JKR grains do.

    build/similitude simulate examples/transfer/truth --out out/transfer-curves
    for s in 11 12; do build/similitude simulate examples/transfer/truth --experiment heap --engine lammps \\
        --contact lammps --seed $s --out out/transfer-$s; done
    python3 examples/transfer/make_recordings.py out
"""
import csv
import pathlib
import random
import sys

here = pathlib.Path(__file__).parent
runs = pathlib.Path(sys.argv[1])
random.seed(3)


def rows_of(path):
    with open(path, encoding="utf-8") as file:
        rows = list(csv.reader(file))
    return rows[0], rows[1:]


def write(name, head, rows):
    with open(here / name, "w", encoding="utf-8") as file:
        file.writelines(",".join(row) + "\n" for row in [head, *rows])


for k in (1, 2):
    head, rows = rows_of(runs / "transfer-curves" / f"curve-{k}.csv")
    write(f"curve-{k}.csv", head, [[f"{float(s):.6g}", f"{float(f) + random.gauss(0, 2e-6):.4g}", b] for s, f, b in rows])
for seed in (11, 12):
    head, rows = rows_of(runs / f"transfer-{seed}" / "heap.csv")
    azimuths = sorted({float(row[0]) for row in rows})[::28]
    radii = sorted({float(row[1]) for row in rows})[1::4]
    kept = [row for row in rows if float(row[0]) in azimuths and float(row[1]) in radii]
    write(f"heap-{seed}.csv", head,
          [[f"{float(a):.5g}", f"{float(r):.5g}", f"{float(z) + random.gauss(0, 5e-5):.4g}"] for a, r, z in kept])
