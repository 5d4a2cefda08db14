# SPDX-License-Identifier: MIT
"""Ctrl-C as a terminal sends it: SIGINT to a script that is at work."""
import signal
import subprocess
import sys
import time
import unittest

from common import root, slow_feed

pile_script = f"""
import similitude
whole = similitude.simulate({str(slow_feed)!r}, "small").result()["hash"]
pile = similitude.Pile({str(slow_feed)!r}, "small")
print("ready", flush=True)
try:
    pile.run()
except KeyboardInterrupt:
    print("stopped", 0 < pile.steps and not pile.finished, flush=True)
pile.run()
print("same", pile.result()["hash"] == whole, flush=True)
"""

diagnose_script = f"""
import similitude
print("ready", flush=True)
try:
    similitude.diagnose({str(root / "tests/diagnose/data/drop-air-drag")!r})
except KeyboardInterrupt:
    print("stopped True", flush=True)
"""


class Interrupt(unittest.TestCase):
    def interrupted(self, script, after):
        with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True) as child:
            self.assertEqual(child.stdout.readline(), "ready\n")
            time.sleep(after)
            child.send_signal(signal.SIGINT)
            sent = time.monotonic()
            self.assertEqual(child.stdout.readline(), "stopped True\n")
            took = time.monotonic() - sent
            rest = child.stdout.read()
            self.assertEqual(child.wait(), 0)
        self.assertLess(took, 5.0)  # parts are 0.1 s; the rest is room for a busy machine
        return rest

    def test_a_pile_stops_between_two_steps_and_goes_on_to_the_same_heap(self):
        self.assertEqual(self.interrupted(pile_script, 0.3), "same True\n")

    def test_a_diagnosis_stops(self):
        self.assertEqual(self.interrupted(diagnose_script, 0.3), "")


if __name__ == "__main__":
    unittest.main()
