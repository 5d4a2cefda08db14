# SPDX-License-Identifier: MIT
import json
import os
import pathlib
import subprocess
import tempfile

root = pathlib.Path(__file__).resolve().parents[2]
build = pathlib.Path(os.environ["SIMILITUDE_BUILD"])
zirconia = root / "data/zirconia/case.json"
slow_feed = root / "data/slow-feed/case.json"


def program(*arguments):
    """The command line: exit code, JSON, what it complained of."""
    with tempfile.TemporaryDirectory() as place:
        done = subprocess.run([build / "similitude", *map(str, arguments), "--json", "-"], cwd=place, capture_output=True, text=True)
    return done.returncode, json.loads(done.stdout) if done.stdout else None, done.stderr


# Beads in free fall onto a plate, no air: by hand z = h - g t^2/2 and a rebound to e^2 h.
beads = {
    "format": "similitude-case/1",
    "title": "a bead",
    "grain": {"diameter": "4 mm", "density": "2500 kg/m^3", "youngs_modulus": "3 GPa", "poisson_ratio": 0.3},
    "plate": {"youngs_modulus": "200 GPa", "poisson_ratio": 0.28},
    "surroundings": {"gravity": "9.81 m/s^2"},
    "model": {"physics": ["gravity", "hertz_mindlin"], "parameters": {"restitution": {"value": 0.7}, "sliding_friction": {"value": 0.3}}},
    "experiments": [{"id": "drop-1", "rig": "drop", "conditions": {"height": "100 mm"}}],
}

# The same bead pressed onto the plate and pulled off: 3/2 pi w R by hand.
sticky = beads | {
    "model": {"physics": ["gravity", "hertz_mindlin", "adhesion"], "parameters": {"work_of_adhesion": {"value": "0.1 J/m^2"}}},
    "experiments": [{"id": "curve-1", "rig": "pull_off", "conditions": {"counterpart": "plate", "preload": "1 mN"}}],
}


def case_of(content, folder):
    path = pathlib.Path(folder) / "case.json"
    path.write_text(json.dumps(content))
    return path
