# SPDX-License-Identifier: MIT
"""The script of docs/python.md runs as it is printed there."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from common import root


class Docs(unittest.TestCase):
    def test_the_script_runs_as_printed(self):
        blocks = re.findall(r"```python\n(.*?)```", (root / "docs/python.md").read_text(), re.S)
        self.assertEqual(len(blocks), 1)
        script = blocks[0]
        self.assertLessEqual(len(script.splitlines()), 15)
        with tempfile.TemporaryDirectory() as place:
            os.symlink(root / "examples", pathlib.Path(place) / "examples")
            done = subprocess.run([sys.executable, "-W", "error::FutureWarning", "-c", script], cwd=place, capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("kept", done.stdout)
            self.assertIn("stands for 8.0 real ones", done.stdout)  # 2^3
            self.assertIn("flank_20_80", done.stdout)
            png = (pathlib.Path(place) / "heap.png").read_bytes()
            self.assertTrue(png.startswith(b"\x89PNG"))
            self.assertGreater(len(png), 10000)  # an empty frame has less


if __name__ == "__main__":
    unittest.main()
