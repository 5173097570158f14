# SPDX-License-Identifier: GPL-3.0-or-later
"""Environments keep what the interface of Gymnasium promises."""

import inspect
import types
import unittest
import unittest.mock

import support
import surefoot
from support import np

NAMES = ["pendulum", "compass", "leo", "cliff", "grid-world", "chain", "random-walk",
         "mountain-car", support.ROBOTS / "hopper.toml", support.ROBOTS / "segway.toml"]


def lived(env, seed, steps=300):
    """A record of an episode or more with actions by chance, for comparisons."""
    env.action_space.seed(seed)
    record = [env.reset(seed=seed)]
    for _ in range(steps):
        record.append(env.step(env.action_space.sample()))
        if record[-1][2] or record[-1][3]:
            record.append(env.reset())
    return record


def same(a, b):
    """Equal to the last bit, types too."""
    if type(a) is not type(b):
        return False
    if isinstance(a, dict):
        return a.keys() == b.keys() and all(same(a[k], b[k]) for k in a)
    if isinstance(a, (tuple, list)):
        return len(a) == len(b) and all(map(same, a, b))
    if isinstance(a, np.ndarray):
        return a.dtype == b.dtype and a.tobytes() == b.tobytes()
    return a == b


class Interface(support.Folder):
    def each(self, test):
        for name in NAMES:
            with self.subTest(environment=str(name)), surefoot.make(name) as env:
                test(env)

    def test_spaces(self):
        def test(env):
            about = env.about
            box = env.observation_space
            self.assertEqual(box.shape, (len(about["state"]),))
            self.assertEqual(box.dtype, np.float64)
            self.assertTrue((box.low < box.high).all() or (box.low <= box.high).all())
            self.assertEqual(env.action_space.n, len(about["actions"]))
            self.assertIn(env.action_space.sample(), env.action_space)
            self.assertNotIn(int(env.action_space.n), env.action_space)
            self.assertEqual(env.ranges.shape, (2, *box.shape))
            self.assertIs(env.unwrapped, env)
        self.each(test)

    def test_signatures(self):
        parameters = inspect.signature(surefoot.Environment.reset).parameters
        for name in ("seed", "options"):
            self.assertIsNone(parameters[name].default)
            self.assertEqual(parameters[name].kind, inspect.Parameter.KEYWORD_ONLY)

    def test_a_reset_gives_a_state_and_a_dictionary(self):
        def test(env):
            told = env.reset()
            self.assertIsInstance(told, tuple)
            state, info = told
            self.assertIn(state, env.observation_space)
            self.assertIsInstance(info, dict)
            self.assertIsInstance(env.reset(options={}), tuple)
        self.each(test)

    def test_a_step_gives_five_values(self):
        def test(env):
            for state, *rest in lived(env, 3):
                self.assertIn(state, env.observation_space)
                if len(rest) == 1:
                    continue
                reward, terminated, truncated, info = rest
                self.assertIs(type(reward), float)
                self.assertIs(type(terminated), bool)
                self.assertIs(type(truncated), bool)
                self.assertFalse(terminated and truncated)
                self.assertIs(type(info["fall"]), bool)
                self.assertIs(type(info["success"]), bool)
                self.assertAlmostEqual(sum(info["reward_terms"].values()), reward, 9)
                self.assertEqual(list(info["reward_terms"]), env.about["reward_terms"])
        self.each(test)

    def test_the_same_seed_gives_the_same_bits(self):
        for name in NAMES:
            with self.subTest(environment=str(name)), surefoot.make(name) as env, \
                    surefoot.make(name) as other:
                first = lived(env, 7)
                self.assertTrue(same(first, lived(other, 7)))
                self.assertTrue(same(first, lived(env, 7)))
                self.assertFalse(same(first, lived(env, 8)))

    def test_random_numbers(self):
        with surefoot.make("pendulum") as env, surefoot.make("pendulum") as other:
            a, b = env.reset()[0], other.reset()[0]  # seeds drawn by chance
            self.assertFalse(np.array_equal(a, b))
            self.assertTrue(np.array_equal(other.reset(seed=env.np_random_seed)[0], a))
            env.reset(seed=123)
            first, before = env.np_random.bit_generator.state, env.np_random_seed
            env.step(0)
            self.assertEqual(before, 123)
            env.reset(seed=123)
            self.assertEqual(env.np_random.bit_generator.state, first)
            env.reset(seed=456)
            self.assertNotEqual(env.np_random.bit_generator.state, first)
            env.reset(seed=np.int64(3))
            env.reset(seed=2**64 - 1)

    def test_what_is_handed_out_is_not_written_again(self):
        with surefoot.make("pendulum") as env:
            first, _ = env.reset(seed=1)
            kept = first.copy()
            second = env.step(1)[0]
            env.step(1)
            self.assertTrue(np.array_equal(first, kept))
            self.assertFalse(np.shares_memory(first, second))

    def test_a_given_state(self):
        with surefoot.make("pendulum") as env:
            state, _ = env.reset(seed=1, options={"state": [0.1, 0.2, -0.3]})
            np.testing.assert_allclose(state, [0.1, 0.2, -0.3], atol=1e-12)
            np.testing.assert_array_equal(env.state, state)
            with self.refused(surefoot.UsageError):
                env.reset(options={"state": [9.0, 0, 0]})
            with self.refused(ValueError):
                env.reset(options={"state": [0.1, 0]})
            with self.refused(surefoot.UsageError, "finite"):
                env.reset(options={"state": [np.nan, 0, 0]})
            with self.refused(surefoot.UsageError, "mood"):
                env.reset(options={"mood": 1})
            with self.refused(TypeError):
                env.reset(options=[1])

    def test_a_fall_is_told(self):
        with surefoot.make("pendulum") as env:
            env.reset(seed=1, options={"state": [1.40, 5.0, 0]})
            *_, terminated, truncated, info = env.step(2)
            self.assertTrue(terminated and info["fall"] and not truncated)
            self.assertFalse(info["success"])
            with self.refused(surefoot.UsageError):
                env.step(2)  # it is over
            env.reset()
            env.step(2)

    def test_a_time_limit_truncates(self):
        with surefoot.make("mountain-car", max_steps=5) as env:
            env.reset(seed=1)
            told = [env.step(1) for _ in range(5)]
            self.assertEqual([t[3] for t in told], [False] * 4 + [True])
            self.assertFalse(told[-1][2])

    def test_signals_measures_pushes(self):
        with surefoot.make("pendulum") as env:
            env.reset(seed=1, options={"state": [0.0, 0, 0]})
            self.assertEqual(list(env.signals()), [s["key"] for s in env.about["signals"]])
            env.push(0.05)
            self.assertNotEqual(env.step(2)[0][1], 0.0)
        with surefoot.make("compass") as env:
            env.reset(seed=1)
            env.step(0)
            self.assertEqual(list(env.measures()), [m["key"] for m in env.about["measures"]])
        with surefoot.make("leo") as env:
            env.reset(seed=1)
            self.assertIn(env.hand_made(), env.action_space)
        with surefoot.make("cliff") as env, self.refused(surefoot.UsageError):
            env.reset(seed=1)
            env.push(1.0)

    def test_parameters(self):
        with surefoot.make("pendulum", damping=0.2) as a, \
                surefoot.make("pendulum", parameters={"environment.damping": 0.2}) as b, \
                surefoot.make("pendulum") as c:
            c.set("damping", 0.2)
            self.assertTrue(same(lived(a, 1), lived(b, 1)))
            self.assertTrue(same(lived(a, 1), lived(c, 1)))
            with surefoot.make("pendulum") as plain:
                self.assertFalse(same(lived(a, 1), lived(plain, 1)))
            with self.refused(surefoot.UsageError):
                c.set("damping", "wet")
            with self.refused(surefoot.UsageError, "finite"):
                c.set("damping", float("nan"))
            with self.refused(TypeError):
                c.set(3, 0.2)
        with self.refused(surefoot.UsageError, "twice"):
            surefoot.make("pendulum", damping=0.2, parameters={"environment.damping": 0.2})

    def test_pictures(self):
        with surefoot.make("pendulum", render_mode="rgb_array", render_size=(160, 100)) as env:
            env.reset(seed=1)
            picture = env.render()
            self.assertEqual((picture.shape, picture.dtype), ((100, 160, 3), np.uint8))
            self.assertGreater(len(np.unique(picture.reshape(-1, 3), axis=0)), 3)
            env.reset(options={"state": [1.2, 0, 0]})
            self.assertFalse(np.array_equal(env.render(), picture))
            self.assertIn(env.render_mode, env.metadata["render_modes"])
            self.assertGreater(env.metadata["render_fps"], 0)
            self.assertIn("shapes", env.draw())
        with surefoot.make("pendulum") as env:
            env.reset(seed=1)
            self.assertIsNone(env.render())
        with self.refused(surefoot.UsageError, "ansi"):
            surefoot.make("pendulum", render_mode="ansi")
        for size in ((0, 100), (5000, 100), (100.5, 100), 7, (1, 2, 3)):
            with self.refused(surefoot.Error):
                surefoot.make("pendulum", render_size=size)

    def test_wrong_names(self):
        for name in ("pendulumm", "no.toml", "", "a\0b", "\udcff.toml", str(self.folder)):
            with self.subTest(name=name), self.refused(surefoot.Error):
                surefoot.make(name)
        for name in (None, 3, b"pendulum", ["pendulum"], np.zeros(3)):
            with self.subTest(name=name), self.refused(TypeError):
                surefoot.make(name)
        with self.refused(surefoot.UsageError):
            surefoot.make("pendulum", preset="lob")
        with self.refused(surefoot.UsageError):
            surefoot.make("pendulum", scenario="7")
        with self.refused(surefoot.UsageError):
            surefoot.make("pendulum", dampening=0.2)
        with self.refused(surefoot.UsageError):
            surefoot.make("pendulum", damping=-1)
        with self.refused(surefoot.Error):
            surefoot.make("pendulum", damping=float("inf"))
        with self.refused(surefoot.Error):
            surefoot.make("pendulum", damping=object())
        with self.refused(TypeError):
            surefoot.make("pendulum", parameters=[1])
        with self.refused(surefoot.UsageError):
            surefoot.make("pendulum", policy__epsilon=0.1)

    def test_wrong_actions_and_seeds(self):
        with surefoot.make("pendulum") as env:
            with self.refused(surefoot.UsageError):
                env.step(0)  # not begun
            env.reset(seed=1)
            for action in (-1, 5, 2**70, -2**70, np.int64(9)):
                with self.subTest(action=action), self.refused(ValueError, "0 … 4"):
                    env.step(action)
            for action in (None, 1.0, "1", [1], np.nan, True, np.zeros(1), np.float64(1)):
                with self.subTest(action=action), self.refused(TypeError):
                    env.step(action)
            env.step(np.int32(1)), env.step(np.array(1))
            for seed in (-1, 2**64):
                with self.refused(ValueError, "seed"):
                    env.reset(seed=seed)
            for seed in (1.5, "1", True, [1]):
                with self.refused(TypeError, "seed"):
                    env.reset(seed=seed)

    def test_closed(self):
        env = surefoot.make("pendulum", render_mode="rgb_array")
        env.reset(seed=1)
        env.close()
        env.close()
        for call in (lambda: env.step(0), env.reset, env.render, lambda: env.about,
                     env.signals, lambda: env.push(1.0), env.draw, lambda: env.state):
            with self.refused(surefoot.UsageError, "closed"):
                call()
        self.assertIn("closed", repr(env))

    def test_what_is_registered_stays_as_it_is(self):
        registered = types.SimpleNamespace(kwargs={"name": "pendulum"})
        known = types.SimpleNamespace(spec=lambda name: registered)
        with unittest.mock.patch("surefoot._kinds.gymnasium", known):
            with surefoot.make("pendulum", preset="lab") as env:
                self.assertEqual(env.spec.kwargs, {"name": "pendulum", "preset": "lab"})
        self.assertEqual(registered.kwargs, {"name": "pendulum"}, "else all are of the lab")

    def test_no_copies(self):
        import copy
        import pickle
        with surefoot.make("pendulum") as env:
            for call in (copy.copy, copy.deepcopy, pickle.dumps):
                with self.refused(TypeError):
                    call(env)


if __name__ == "__main__":
    unittest.main()
