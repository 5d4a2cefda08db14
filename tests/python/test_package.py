# SPDX-License-Identifier: MIT
"""Installed and packed, the module is imported from there."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from common import build, zirconia


class Package(unittest.TestCase):
    def ask(self, folder):
        script = f"import similitude; print(similitude.__file__); print(similitude.scale({str(zirconia)!r})['h'])"
        done = subprocess.run([sys.executable, "-c", script], env={"PYTHONPATH": str(folder)}, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.splitlines(), [str(folder / "similitude/__init__.py"), "200.0"])

    def test_installed(self):
        with tempfile.TemporaryDirectory() as place:
            subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix", place], check=True, capture_output=True)
            folder = pathlib.Path(place) / "lib/python3/dist-packages"
            self.assertTrue((folder / "similitude/py.typed").exists())
            self.ask(folder)

    @unittest.skipUnless(shutil.which("dpkg-shlibdeps"), "dpkg-dev is not installed")
    def test_packed_for_debian(self):
        with tempfile.TemporaryDirectory() as place:
            subprocess.run(["cpack", "--config", build / "CPackConfig.cmake", "-D", "CPACK_COMPONENTS_ALL=python", "-B", place],
                           check=True, capture_output=True)
            deb, = pathlib.Path(place).glob("python3-similitude_*.deb")
            depends = subprocess.run(["dpkg-deb", "-f", deb, "Depends"], check=True, capture_output=True, text=True).stdout
            for needed in ("libudunits2", "python3 (<< 3.12)", "python3-numpy"):
                self.assertIn(needed, depends)
            subprocess.run(["dpkg-deb", "-x", deb, place + "/root"], check=True)
            self.ask(pathlib.Path(place) / "root/usr/lib/python3/dist-packages")


if __name__ == "__main__":
    unittest.main()
