# SPDX-License-Identifier: GPL-3.0-or-later
"""n worlds in one call are n single ones, bit for bit, however they begin again."""

import unittest

import support
import surefoot
from support import np

N = 7


def actions_of(number, steps, n=N, seed=1):
    return np.random.default_rng(seed).integers(0, number, (steps, n))


class Vector(support.Folder):
    def test_next_step(self):
        for name, steps in (("pendulum", 600), ("compass", 200), ("random-walk", 200),
                            ("chain", 200), (support.ROBOTS / "hopper.toml", 200)):
            with self.subTest(name=str(name)), surefoot.make_vec(name, N) as envs:
                self.compare(name, envs, steps)

    def compare(self, name, envs, steps):
        singles = [surefoot.make(name) for _ in range(N)]
        states, infos = envs.reset(seed=40)
        self.assertEqual(infos, {})
        ended = [False] * N
        endings = 0
        for i, env in enumerate(singles):
            np.testing.assert_array_equal(states[i], env.reset(seed=40 + i)[0])
        for row in actions_of(int(singles[0].action_space.n), steps):
            states, rewards, terminated, truncated, infos = envs.step(row)
            for i, env in enumerate(singles):
                if ended[i]:
                    told = (*env.reset()[:1], 0.0, False, False, None)
                else:
                    told = env.step(int(row[i]))
                self.assertEqual(states[i].tobytes(), told[0].tobytes())
                self.assertEqual((rewards[i], terminated[i], truncated[i]), told[1:4])
                self.assertEqual(infos["_fall"][i], not ended[i])
                if not ended[i]:
                    self.assertEqual(infos["fall"][i], told[4]["fall"])
                    self.assertEqual(infos["success"][i], told[4]["success"])
                    self.assertEqual({k: infos["reward_terms"][k][i]
                                      for k in told[4]["reward_terms"]}, told[4]["reward_terms"])
                ended[i] = told[2] or told[3]
                endings += ended[i]
        self.assertGreater(endings, 0)

    def test_same_step(self):
        with surefoot.make_vec("pendulum", N, autoreset="same_step") as envs:
            singles = [surefoot.make("pendulum") for _ in range(N)]
            envs.reset(seed=9)
            for i, env in enumerate(singles):
                env.reset(seed=9 + i)
            endings = 0
            for row in actions_of(5, 500):
                states, rewards, terminated, truncated, infos = envs.step(row)
                for i, env in enumerate(singles):
                    state, reward, *flags, info = env.step(int(row[i]))
                    self.assertEqual([terminated[i], truncated[i]], flags)
                    self.assertEqual(rewards[i], reward)
                    if any(flags):
                        endings += 1
                        self.assertTrue(infos["_final_obs"][i] and infos["_final_info"][i])
                        np.testing.assert_array_equal(infos["final_obs"][i], state)
                        self.assertEqual(infos["final_info"]["fall"][i], info["fall"])
                        self.assertFalse(infos["_fall"][i])
                        state = env.reset()[0]
                    else:
                        self.assertEqual(infos["fall"][i], info["fall"])
                        self.assertTrue("_final_obs" not in infos or not infos["_final_obs"][i])
                    np.testing.assert_array_equal(states[i], state)
            self.assertGreater(endings, 5)

    def test_disabled(self):
        with surefoot.make_vec("pendulum", N, autoreset="disabled") as envs:
            envs.reset(seed=9)
            over = np.zeros(N, bool)
            for row in actions_of(5, 300):
                states, rewards, terminated, truncated, _ = envs.step(row)
                self.assertTrue((rewards[over] == 0).all())
                self.assertTrue((terminated | truncated)[over].all())
                if over.any():
                    np.testing.assert_array_equal(states[over], before[over])
                before, over = states, terminated | truncated
            self.assertGreater(over.sum(), 1)
            states, _ = envs.reset(options={"reset_mask": over})
            np.testing.assert_array_equal(states[~over], before[~over])
            self.assertFalse(np.array_equal(states[over], before[over]))
            _, _, terminated, *_ = envs.step(np.full(N, 2))
            self.assertFalse(terminated.any())
            for mask in (np.zeros(N, bool), np.ones(N + 1, bool), np.ones(N), [True] * N, 3):
                with self.refused(surefoot.Error, "reset_mask"):
                    envs.reset(options={"reset_mask": mask})

    def test_spaces(self):
        with surefoot.make_vec("pendulum", N) as envs:
            self.assertEqual(envs.num_envs, N)
            self.assertEqual(envs.observation_space.shape, (N, 3))
            self.assertEqual(envs.action_space.shape, (N,))
            self.assertEqual(envs.single_observation_space.shape, (3,))
            self.assertEqual(envs.single_action_space.n, 5)
            states, _ = envs.reset()
            self.assertIn(states, envs.observation_space)
            told = envs.step(envs.action_space.sample())
            self.assertEqual([a.dtype for a in told[:4]], [np.float64, np.float64, bool, bool])
            self.assertEqual([a.shape for a in told[:4]], [(N, 3), (N,), (N,), (N,)])
            self.assertIs(envs.metadata["autoreset_mode"], envs.autoreset_mode)
            self.assertEqual(envs.autoreset_mode.value, "NextStep")
            kept = [a.copy() for a in told[:4]]
            envs.step(envs.action_space.sample())
            for a, b in zip(told, kept):
                np.testing.assert_array_equal(a, b)

    def test_seeds(self):
        with surefoot.make_vec("pendulum", 3) as envs:
            a = envs.reset(seed=[5, 6, 7])[0]
            np.testing.assert_array_equal(a, envs.reset(seed=5)[0])
            b = envs.reset()[0]
            self.assertFalse(np.array_equal(a, b))
            envs.reset(seed=5)
            np.testing.assert_array_equal(b, envs.reset()[0])
            for seed in ([1, 2], 2**64 - 1, -1, [1, 2, -3], "x", 1.5, [1, None, 2]):
                with self.subTest(seed=seed), self.refused(surefoot.Error, "seed"):
                    envs.reset(seed=seed)
        with surefoot.make_vec("pendulum", 3) as one, surefoot.make_vec("pendulum", 3) as other:
            self.assertFalse(np.array_equal(one.reset()[0], other.reset()[0]))

    def test_wrong(self):
        for count in (0, -1, 100_001, 2**80, 1.5, "3", None, True):
            with self.subTest(count=count), self.refused(surefoot.Error, "num_envs"):
                surefoot.make_vec("pendulum", count)
        for mode in ("sometimes", None, 3):
            with self.subTest(mode=mode), self.refused(surefoot.UsageError, "autoreset"):
                surefoot.make_vec("pendulum", 2, autoreset=mode)
        with self.refused(surefoot.UsageError):
            surefoot.make_vec("pendulum", 2, render_mode="human")
        with surefoot.make_vec("pendulum", 3) as envs:
            with self.refused(surefoot.UsageError):
                envs.step(np.zeros(3, int))  # not begun
            envs.reset(seed=1)
            for actions in ([0, 1], [0, 1, 5], [0, -1, 2], [[0, 1, 2]], [0, 1, 2**63]):
                with self.subTest(actions=actions), self.refused(surefoot.Error, "actions"):
                    envs.step(actions)
            for actions in ([0.0, 1, 2], "012", None, [None] * 3, [True] * 3, [[1], [1, 2]]):
                with self.subTest(actions=actions), self.refused(surefoot.Error):
                    envs.step(actions)
            envs.step([0, 1, 2])
        for call in (envs.reset, lambda: envs.step([0, 1, 2]), lambda: envs.about):
            with self.refused(surefoot.UsageError, "closed"):
                call()
        envs.close()


if __name__ == "__main__":
    unittest.main()
