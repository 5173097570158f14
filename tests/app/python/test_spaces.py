# SPDX-License-Identifier: GPL-3.0-or-later
"""The spaces of environments, this package's or Gymnasium's."""

import unittest

import support  # noqa: F401
import surefoot
from support import np


class Spaces(unittest.TestCase):
    """The spaces, ours or Gymnasium's, say yes and no alike."""

    def test_box(self):
        with surefoot.make("pendulum") as env, surefoot.make("pendulum") as other:
            space = env.observation_space
            self.assertIn(np.full(3, 1e9), space)
            self.assertIn(space.sample(), space)
            self.assertEqual(space, other.observation_space)
            self.assertNotEqual(space, other.action_space)
            box = type(space)(np.array([0.0, -np.inf]), np.array([1.0, 5.0]), dtype=np.float64)
        for inside in ([0, 0], [1, 5], [0.5, -1e9]):
            self.assertIn(np.array(inside, float), box)
        for outside in ([1.1, 0], [0, 5.1], [0, np.nan], [0], [0, 0, 0]):
            self.assertNotIn(np.array(outside, float), box)
        for other in ("ab", None, 3):
            self.assertNotIn(other, box)
        box.seed(3)
        first = [box.sample() for _ in range(50)]
        box.seed(3)
        for sample in first:
            self.assertIn(sample, box)
            self.assertTrue(np.array_equal(box.sample(), sample))

    def test_discrete(self):
        with surefoot.make("pendulum") as env:
            space = env.action_space
            space.seed(5)
            drawn = [int(space.sample()) for _ in range(200)]
            self.assertEqual(set(drawn), set(range(5)))
            for no in (-1, 5, 1.0, "1", None, np.zeros(2)):
                self.assertNotIn(no, space)
            self.assertIn(np.int64(4), space)


if __name__ == "__main__":
    unittest.main()
