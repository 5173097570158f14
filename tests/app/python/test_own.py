# SPDX-License-Identifier: GPL-3.0-or-later
"""A world and a policy of one's own under the library's learner."""

import unittest

import support
import surefoot
from support import np

notebooks = support.SOURCE / "app" / "python" / "notebooks"


class Walk:
    """Places 0 … 6 in a row; left of them is a fall, right of them the goal."""

    task = {"title": "walk", "actions": ["left", "right"], "can_fall": True, "goal_reward": 1,
            "state": [{"key": "place", "low": 0, "high": 6, "whole": True}]}

    def __init__(self):
        self.seeds, self.fail_at, self.steps = [], None, 0

    def reset(self, seed):
        self.seeds.append(seed)
        self.place = 3
        return self.place

    def step(self, action):
        self.steps += 1
        if self.steps == self.fail_at:
            raise KeyError("lost")
        self.place += 1 if action == 1 else -1
        fall, success = self.place < 0, self.place > 6
        return ([min(max(self.place, 0), 6)], -1.0 if fall else 1.0 if success else 0.0,
                fall or success, False, {"fall": fall, "success": success})


class OwnWorlds(support.Folder):
    def test_it_is_learned(self):
        world = Walk()
        with surefoot.Life(environment=world, features="table", seed=1) as life:
            totals = life.run(episodes=300)
            self.assertEqual(totals.steps, world.steps)
            self.assertGreater(totals.successes, 250)
            self.assertEqual(totals.falls + totals.successes, 300)
            q = life.values(np.arange(7)[:, None])
            self.assertTrue((q[:, 1] > q[:, 0]).all())
            self.assertEqual(len(set(world.seeds)), len(world.seeds))
            self.assertEqual(life.task["state"][0]["key"], "place")

    def test_it_is_the_librarys_own_where_it_does_the_same(self):
        """The mountain car of the library, asked through Python, lives the same life."""
        inner = surefoot.make("mountain-car")
        about = inner.about
        terms = len(about["reward_terms"])

        class Same:
            task = {"state": about["state"], "actions": [a[0] for a in about["actions"]],
                    "can_fall": False, "reward_terms": about["reward_terms"]}
            begin = None

            def reset(self, seed):
                return inner.reset(seed=seed)

            def step(self, action):
                return inner.step(action)

        self.assertGreaterEqual(terms, 1)
        with surefoot.Life(environment=Same(), seed=2) as a, \
                surefoot.Life(environment=Same(), seed=2) as b:
            a.run(steps=2000)
            b.run(steps=1000), b.run(steps=1000)
            self.assertEqual(a.hash, b.hash)

    def test_from_spaces(self):
        class Spaced(Walk):
            def __init__(self):
                super().__init__()
                with surefoot.make("cliff") as env:
                    box, discrete = type(env.observation_space), type(env.action_space)
                self.observation_space = box(np.array([0.0]), np.array([6.0]), dtype=np.float64)
                self.action_space = discrete(2)
            task = None

            def reset(self, seed=None, options=None):
                return np.array([super().reset(seed)]), {}
        with surefoot.Life(environment=Spaced(), seed=1) as life:
            self.assertEqual(life.run(steps=100).steps, 100)
            self.assertEqual(life.task["state"][0]["high"], 6)
        unbounded = Spaced()
        unbounded.observation_space.high[:] = np.inf
        with self.refused(surefoot.UsageError, "high"):
            surefoot.Life(environment=unbounded)
        with surefoot.Life(environment=unbounded,
                           task={"state": [{"key": "x", "high": 6}]}) as life:
            self.assertEqual(life.task["state"][0]["key"], "x")

    def test_an_exception_comes_out_and_the_life_goes_on(self):
        world, other = Walk(), Walk()
        with surefoot.Life(environment=world, features="table") as life, \
                surefoot.Life(environment=other, features="table") as calm:
            world.fail_at = 50
            with self.assertRaisesRegex(KeyError, "lost"):
                life.run(steps=100)
            self.assertEqual(life.totals.steps, 49)
            life.values([[0.0]])
            life.run(steps=51)
            calm.run(steps=100)
            self.assertEqual(life.hash, calm.hash)

    def test_it_gives_nonsense(self):
        for answer in (None, 3, (1, 2), ([1], "much", False, False, {}),
                       ([1], np.nan, False, False, {}), ([np.nan], 0.0, False, False, {}),
                       ([1, 2], 0.0, False, False, {}), ([1], 0.0, False, False, None),
                       (["x"], 0.0, False, False, {})):
            world = Walk()
            world.step = lambda action, answer=answer: answer
            with self.subTest(answer=answer), surefoot.Life(environment=world) as life:
                with self.assertRaises(Exception):
                    life.run(steps=10)
                self.assertEqual(life.totals.steps, 0)
                del world.step
                life.run(steps=10)
        world = Walk()
        world.reset = lambda seed: 1 / 0
        with surefoot.Life(environment=world) as life:
            for _ in range(2):
                with self.assertRaises(ZeroDivisionError):
                    life.run(steps=10)
            del world.reset
            life.run(steps=10)

    def test_wrong_tasks(self):
        for task in (3, {"state": 3}, {"state": []}, {"state": [{"key": "x"}]}, {"actions": []},
                     {"state": [{"key": "x", "low": 1, "high": 0}]}, {"actions": [np.nan]},
                     {"reward_terms": [1]}, {"step_time": -1}, {"colour": "red"},
                     {"state": [{"key": "x", "low": 0, "high": np.inf}]},
                     {"actions": [object()]}):
            with self.subTest(task=task), self.refused(surefoot.Error):
                world = Walk()
                surefoot.Life(environment=world, task={**Walk.task, **task}
                              if isinstance(task, dict) else task)
        for world in (3, object(), surefoot.make("pendulum")):
            with self.subTest(world=world), self.refused(surefoot.Error):
                surefoot.Life(environment=world)
        with self.refused(surefoot.UsageError, "task"):
            surefoot.Life(environment="cliff", task=Walk.task)

    def test_it_may_not_reach_into_its_own_life(self):
        class Greedy(Walk):
            def step(self, action):
                self.life.values([[0.0]])
                return super().step(action)
        world = Greedy()
        with surefoot.Life(environment=world) as life:
            world.life = life
            with self.refused(surefoot.BusyError):
                life.run(steps=10)
            with self.refused(surefoot.BusyError):
                world.step = lambda action: life.close()
                life.run(steps=10)
            del world.step
            world.life = surefoot.Life(environment=Walk())
            life.run(steps=10)

    def test_saved_and_resumed(self):
        file = self.folder / "life.safetensors"
        with surefoot.Life(environment=Walk(), features="table", seed=1) as life:
            life.run(steps=500)
            life.checkpoint(file)
            life.run(steps=500)
            with surefoot.resume(file, environment=Walk()) as again:
                again.run(steps=500)
                self.assertEqual(life.hash, again.hash)
        with self.refused(surefoot.Error):
            surefoot.resume(file)

    def test_its_progress_is_printed(self):
        told = support.python(
            "import sys; sys.path.insert(0, sys.argv[1]) if len(sys.argv) > 1 else None\n"
            "import surefoot\n"
            "surefoot.Life(seed=1).run(steps=1000, progress=True)")
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertRegex(told.stderr, r"1,000 steps, [\d,]+ steps/s")


class OwnPolicies(support.Folder):
    def test_greedy_in_python_is_greedy(self):
        def greedy(q):
            return q == q.max()
        with surefoot.Life(policy=greedy, seed=1) as a, \
                surefoot.Life(policy="greedy", seed=1) as b:
            self.assertEqual(a.run(steps=3000), b.run(steps=3000))
            state = [0.1, 0, 0]
            np.testing.assert_array_equal(a.probabilities(state), b.probabilities(state))

    def test_what_is_wrong_with_it_comes_out(self):
        for answer in (None, [1], [1, 2, 3, 4, -1], [0] * 5, [np.nan] * 5, "abc", [[1] * 5]):
            told = []

            def policy(q, answer=answer, told=told):
                told.append(q)
                return answer if len(told) == 20 else np.ones(5)
            with self.subTest(answer=answer), surefoot.Life(policy=policy, seed=1) as life:
                with self.assertRaises((ValueError, TypeError)):
                    life.run(steps=1000)
                life.run(steps=1000)
                self.assertEqual(told[0].shape, (5,))

        def raises(q):
            raise LookupError("none")
        with surefoot.Life(policy=raises) as life:
            for call in (lambda: life.run(steps=10), lambda: life.probabilities([0, 0, 0])):
                with self.assertRaises(LookupError):
                    call()

    def test_both(self):
        with surefoot.Life(environment=Walk(), features="table",
                           policy=lambda q: np.exp(q - q.max())) as life:
            self.assertEqual(life.run(episodes=50).episodes, 50)


if __name__ == "__main__":
    unittest.main()
