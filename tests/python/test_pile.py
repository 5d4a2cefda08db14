# SPDX-License-Identifier: MIT
import gc
import threading
import unittest

import numpy as np

import similitude
from common import program, slow_feed


def address(array):
    return array.__array_interface__["data"][0]


class Result(unittest.TestCase):
    def test_is_that_of_the_command_line_to_the_last_bit(self):
        _, expected, trouble = program("simulate", slow_feed, "--experiment", "small", "--seed", 3, "--quiet")
        self.assertIsNotNone(expected, trouble)
        pile = similitude.simulate(slow_feed, "small", seed=3)
        heap = pile.result()
        self.assertEqual(dict(heap), expected["runs"][0]["result"])  # its hash of all grains too
        self.assertEqual(heap.table().loc["cone", "angle"], heap["angle_of_repose"]["cone"]["angle"])
        self.assertTrue(pile.finished and pile.at_rest)
        r, z = pile.profile()
        self.assertEqual(r.shape, z.shape)
        self.assertIn("<svg", heap.page())

    def test_is_not_there_before_the_end(self):
        pile = similitude.Pile(slow_feed, "small")
        pile.advance(10)
        self.assertEqual(pile.steps, 10)
        self.assertAlmostEqual(pile.time, 10 * pile.time_step, delta=1e-15)
        for early in (pile.result, pile.profile):
            with self.assertRaisesRegex(RuntimeError, "small: the pile has not come to its end; call run()"):
                early()
        self.assertIn("step 10 of", repr(pile))
        self.assertIn("step 10 of", pile._repr_html_())
        with self.assertRaisesRegex(ValueError, "steps: got -1, must be >= 0"):
            pile.advance(-1)


class Views(unittest.TestCase):
    def setUp(self):
        self.pile = similitude.Pile(slow_feed, "small", seed=2)
        self.pile.advance(30000)

    def test_are_the_cores_own_memory(self):
        for name in ("x", "vz", "wy", "radius", "mass", "id", "material"):
            first, second = getattr(self.pile, name), getattr(self.pile, name)
            self.assertEqual(address(first), address(second), name)
            self.assertFalse(first.flags.owndata or first.flags.writeable)
            with self.assertRaises(ValueError):
                first.flags.writeable = True
        self.assertEqual(self.pile.x.dtype, np.float64)
        self.assertEqual(self.pile.id.dtype, np.int64)

    def test_show_the_grains_of_the_case(self):
        # 1 mm beads of 2500 kg/m^3: pi/6 d^3 rho by hand.
        pile = self.pile
        self.assertGreater(pile.fed, 0)
        self.assertEqual(len(pile.x), np.count_nonzero(pile.fixed) + pile.fed - pile.lost)
        np.testing.assert_allclose(pile.radius, 0.5e-3, rtol=1e-15)
        np.testing.assert_allclose(pile.mass, np.pi / 6 * 1e-9 * 2500, rtol=1e-12)
        np.testing.assert_array_equal(np.unique(pile.id), np.sort(pile.id))
        glued = pile.z[pile.fixed]
        np.testing.assert_allclose(glued, -0.5e-3, rtol=1e-12)  # their tops at 0
        grains = pile.table()
        self.assertEqual(grains.loc[pile.id[7], "x"], pile.x[7])

    def test_one_that_is_kept_stays_what_it_was(self):
        pile = self.pile
        kept, again, gone = pile.z, pile.z, pile.x
        before, where = kept.copy(), address(kept)
        del gone
        pile.advance(5000)
        self.assertEqual(address(kept), where)
        np.testing.assert_array_equal(kept, before)
        np.testing.assert_array_equal(again, before)
        self.assertNotEqual(address(pile.z), where)
        self.assertFalse(np.array_equal(pile.z, before))
        pile.advance(5000)
        np.testing.assert_array_equal(kept, before)

    def test_one_outlives_its_pile(self):
        kept, before = self.pile.z, self.pile.z.copy()
        del self.pile
        gc.collect()
        similitude.Pile(slow_feed, "small").advance(20000)  # takes memory that was given back
        np.testing.assert_array_equal(kept, before)

    def test_keeping_them_changes_no_bit(self):
        def hash_of(keep):
            pile, kept = similitude.Pile(slow_feed, "small"), []
            while not pile.finished:
                pile.advance(7919)
                if keep:
                    kept.append((pile.x, pile.vz, pile.radius, pile.id))
            return pile.result()["hash"]

        self.assertEqual(hash_of(True), hash_of(False))


class Threads(unittest.TestCase):
    def test_others_run_meanwhile_and_may_not_look(self):
        pile = similitude.Pile(slow_feed, "small")
        kept, before = pile.z, pile.z.copy()
        runner = threading.Thread(target=pile.run)
        runner.start()
        refused = 0
        while runner.is_alive():
            try:
                pile.steps
            except RuntimeError as error:
                self.assertIn("stepped by another thread", str(error))
                refused += 1
            self.assertTrue(np.array_equal(kept, before))
        runner.join()
        self.assertGreater(refused, 100)  # this loop ran while the core did
        self.assertTrue(pile.finished)


if __name__ == "__main__":
    unittest.main()
