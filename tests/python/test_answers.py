# SPDX-License-Identifier: MIT
"""Python and the command line give one answer; what is expected beside that is done by hand or stands in the paper."""
import json
import math
import os
import pathlib
import pickle
import tempfile
import unittest

import numpy as np

import similitude
from common import beads, case_of, program, root, sticky, zirconia


def without(data, *keys):
    """The same, without what moves from call to call: who asked, and how fast the machine was."""
    if isinstance(data, dict):
        if data.get("name") == "implied_speed_over_measured":
            keys += ("value", "text")
        return {k: without(v, *keys) for k, v in data.items() if k not in keys}
    return [without(v, *keys) for v in data] if isinstance(data, list) else data


class Scale(unittest.TestCase):
    def test_is_the_json_of_the_command_line(self):
        for python, typed in [
            ({}, []),
            ({"h": 50, "scheme": "kept_gravity"}, ["--h", 50, "--scheme", "kept_gravity"]),
            (
                {"keep": ["density", "gravity", "youngs_modulus"], "distorted": True, "invariant": "stress_bond",
                 "surface_energy": "30 mJ/m^2", "of": "original"},
                ["--keep", "density,gravity,youngs_modulus", "--distorted", "--invariant", "stress_bond",
                 "--surface-energy", "30 mJ/m^2", "--of", "original"],
            ),
        ]:
            _, expected, trouble = program("scale", zirconia, *typed)
            self.assertIsNotNone(expected, trouble)
            moves = ("tool", "wall_time", "grain_steps_per_second")
            got = similitude.scale(zirconia, **python)
            self.assertEqual(without(dict(got), *moves), without(expected, *moves))
            self.assertEqual(list(got), list(expected))  # in the same order

    def test_exponents_of_the_papers_table_2(self):
        # Niu et al. (2026), Table 2: length and time h, mass h^3, force h^2, stress 1.
        factors = similitude.scale(zirconia, scheme="exact")["factors"]
        for name, exponent in [("length", "1"), ("time", "1"), ("mass", "3"), ("force", "2"), ("stress", "0")]:
            self.assertEqual(factors[name]["exponent"], exponent, name)
        self.assertEqual(factors["mass"]["factor"], 200.0**3)

    def test_types_are_pythons_own(self):
        study = similitude.scale(zirconia)
        self.assertIs(type(study["h"]), float)
        self.assertIs(type(study["distorted"]), bool)
        self.assertIs(type(study["findings"]), list)
        self.assertEqual(json.loads(json.dumps(study)), study)
        back = pickle.loads(pickle.dumps(study))
        self.assertIs(type(back), dict)
        self.assertEqual(back, study)

    def test_command_says_what_was_asked(self):
        study = similitude.scale(zirconia, h=50, scheme="exact")
        self.assertEqual(study["tool"]["command"], f"similitude.scale({str(zirconia)!r}, h=50, scheme='exact')")
        with tempfile.TemporaryDirectory() as place:
            path = case_of(beads, place)
            curves = similitude.predict(path, at=[0, 0.1])
            self.assertIn(f"similitude.predict({str(path)!r}, at=[0.0, 0.1])".replace("'", "&#39;"), curves.page().replace("&apos;", "&#39;"))

    def test_tables(self):
        study = similitude.scale(zirconia)
        factors = study.table()
        self.assertEqual(factors.loc["mass", "factor"], study["factors"]["mass"]["factor"])
        self.assertEqual(len(study.table("findings")), len(study["findings"]))
        with self.assertRaisesRegex(ValueError, "got 'title', must be one of factors, groups, .*findings"):
            study.table("title")

    def test_page(self):
        study = similitude.scale(zirconia)
        page = study.page()
        self.assertTrue(page.startswith("<!DOCTYPE html>"))
        self.assertIn('<section id="groups">', page)
        self.assertIn("similitude-scale/1", page)  # the JSON is in it
        shown = study._repr_html_()
        self.assertTrue(shown.startswith('<iframe srcdoc="&lt;!DOCTYPE html&gt;'))
        self.assertEqual(shown.count('"'), 4)  # nothing of the page ends the attribute
        with tempfile.TemporaryDirectory() as place:
            study.save(place + "/page.html")
            with open(place + "/page.html", encoding="utf-8") as file:
                self.assertEqual(file.read(), page)


class Mistakes(unittest.TestCase):
    def test_text_is_that_of_the_command_line(self):
        bad = json.loads(zirconia.read_text())
        bad["grain"]["diameter"] = "-4 mm"
        with tempfile.TemporaryDirectory() as place:
            path = case_of(bad, place)
            code, _, trouble = program("scale", path)
            self.assertEqual(code, 2)
            with self.assertRaises(ValueError) as raised:
                similitude.scale(path)
            self.assertIsInstance(raised.exception, similitude.InvalidInput)
            self.assertEqual(f"similitude: {raised.exception}\n", trouble)

    def test_each_names_the_place_and_the_rule(self):
        with tempfile.TemporaryDirectory() as place:
            bead = case_of(beads, place)
            os.mkdir(place + "/sticky")
            adhesive = case_of(sticky, place + "/sticky")
            for wrong, text in [
                (lambda: similitude.scale("nowhere"), "nowhere"),
                (lambda: similitude.scale(zirconia, surface_energy="1 J/m^2", of="both"), 'of: got "both", must be original or scaled'),
                (lambda: similitude.scale(zirconia, surface_energy="1 kg", of="scaled"), "kg"),
                (lambda: similitude.simulate(zirconia), "must be a count to be simulated"),
                (lambda: similitude.scale(zirconia, threads=-1), "threads: got -1, must be in"),
                (lambda: similitude.simulate(bead), "got no pile, must hold one"),
                (lambda: similitude.simulate(bead, "drop-1"), "must be of the rig pile"),
                (lambda: similitude.simulate(bead, "drop-2"), "drop-1"),
                (lambda: similitude.predict(zirconia), "got none of a single grain"),
                (lambda: similitude.predict(zirconia, "pile"), "must be drop, incline, impact or pull_off"),
                (lambda: similitude.predict(bead, parameters={"restitutoin": 1.0}), 'got "restitutoin", must be one of .*restitution'),
                (lambda: similitude.predict(bead, parameters={"restitution": 2}), "parameters.restitution: got 2"),
                (lambda: similitude.predict(adhesive, parameters={"work_of_adhesion": 0.2}), "parameters.work_of_adhesion: got 0.2"),
                (lambda: similitude.predict(adhesive, parameters={"work_of_adhesion": "2 m"}), "J/m"),
                (lambda: similitude.diagnose(bead, alpha=2.0), "alpha: got 2"),
            ]:
                with self.assertRaisesRegex(ValueError, text):
                    wrong()
            with self.assertRaises(TypeError):
                similitude.scale(zirconia, scale=200)


class Predict(unittest.TestCase):
    def test_falls_and_bounces_as_by_hand(self):
        with tempfile.TemporaryDirectory() as place:
            path = case_of(beads, place)
            fall = math.sqrt(2 * 0.1 / 9.81)  # s, 100 mm
            for e in (0.7, 0.5):
                t = np.array([0.0, 0.5 * fall, 0.9 * fall, (1 + e) * fall])
                curves = similitude.predict(path, parameters={"restitution": e}, at=t)
                np.testing.assert_array_equal(curves["t"], t)
                np.testing.assert_allclose(curves["z"][:3], 0.1 - 0.5 * 9.81 * t[:3] ** 2, atol=1e-9)
                # The contact takes some 30 us, and flight is flat at its top: 0.5 g (30 us)^2 = 4e-9 m. The weight
                # during contact and e at the speed of the impact leave the rest.
                self.assertAlmostEqual(curves["z"][3], e * e * 0.1, delta=1e-6)
            self.assertEqual(curves.units["z"], "m")
            self.assertIn("z [m]", curves.table().columns)
            self.assertIn("<svg", curves.page())

    def test_stands_at_the_rows_of_the_recording(self):
        curves = similitude.predict(root / "tests/diagnose/data/drop-air-drag", "drop-1")
        rows = (root / "tests/diagnose/data/drop-air-drag/drop-1.csv").read_text().splitlines()
        self.assertEqual(len(curves["t"]), len(rows) - 1)

    def test_a_parameter_carries_its_unit(self):
        # JKR on a plate: the deepest pull is 3/2 pi w R, 2 mm here. A hundred samples of a smooth curve miss it by less than 1e-3.
        with tempfile.TemporaryDirectory() as place:
            path = case_of(sticky, place)
            for stated, w in [(None, 0.1), ("50 mJ/m^2", 0.05), ("0.2 J/m^2", 0.2)]:
                curves = similitude.predict(path, parameters={"work_of_adhesion": stated} if stated else {})
                self.assertAlmostEqual(curves["force"].min() / (-1.5 * math.pi * w * 2e-3), 1.0, delta=1e-3)

    def test_pull_off_has_its_branches(self):
        curves = similitude.predict(root / "tests/diagnose/data/pull-off-adhesion")
        self.assertEqual(set(curves["branch"]), {"approach", "retract"})
        self.assertEqual(len(curves["branch"]), len(curves["force"]))


small_calibration = json.loads("""{
  "format": "similitude-case/1",
  "grain": {"diameter": "4 mm", "density": "1200 kg/m^3", "youngs_modulus": "2 MPa", "poisson_ratio": 0.3},
  "plate": {"youngs_modulus": "200 GPa", "poisson_ratio": 0.3},
  "surroundings": {"gravity": "9.81 m/s^2"},
  "model": {"physics": ["gravity", "hertz_mindlin", "rolling_resistance"],
    "parameters": {"restitution": {"value": 0.4}, "sliding_friction": {"value": 0.5, "range": [0.2, 0.9]},
                   "rolling_friction": {"value": 0.2, "range": [0.1, 0.5]}}},
  "experiments": [{"id": "heap", "rig": "pile", "recording": "angles.csv",
    "conditions": {"base": "flat", "base_diameter": "48 mm", "grains": 300}}]
}""")


class Calibrate(unittest.TestCase):
    def test_is_the_json_of_the_command_line(self):
        with tempfile.TemporaryDirectory() as place:
            path = case_of(small_calibration, place)
            (pathlib.Path(place) / "angles.csv").write_text("angle_of_repose [deg],estimator\n29,two_h_over_d\n31,two_h_over_d\n")
            _, expected, trouble = program("calibrate", path, "--budget", 5, "--confirm", 1, "--quiet", "--out", pathlib.Path(place) / "cli")
            self.assertIsNotNone(expected, trouble)
            got = similitude.calibrate(path, budget=5, confirm=1, out=pathlib.Path(place) / "module")
            self.assertEqual(without(dict(got), "tool"), without(expected, "tool"))
            self.assertEqual(len(got["runs"]), 6)
            self.assertEqual(list(got.table()["name"]), ["rolling_friction", "sliding_friction"])
            self.assertTrue((pathlib.Path(place) / "module/runs.csv").exists())
            self.assertIn("<svg", got.page())
            with self.assertRaisesRegex(similitude.InvalidInput, "surrogate or paper"):
                similitude.calibrate(path, road="shorter")


class Diagnose(unittest.TestCase):
    def test_is_the_json_of_the_command_line(self):
        path = root / "tests/diagnose/data/drop-air-drag"
        _, expected, trouble = program("diagnose", path, "--seed", 2, "--quiet")
        self.assertIsNotNone(expected, trouble)
        got = similitude.diagnose(path, seed=2)
        self.assertEqual(without(dict(got), "tool"), without(expected, "tool"))
        self.assertIn("air_drag", got["hypotheses"][0]["effects"])  # truth.json
        self.assertEqual(list(got.table()["probability"]), [h["probability"] for h in got["hypotheses"]])
        self.assertIn("<svg", got.page())


if __name__ == "__main__":
    unittest.main()
