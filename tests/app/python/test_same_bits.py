# SPDX-License-Identifier: GPL-3.0-or-later
"""Lives through Python are those of the program, bit for bit."""

import unittest

import support
import surefoot
from support import np


class SameBits(support.Folder):
    def same(self, arguments, *, minutes=None, episodes=None, **configuration):
        length = ["--minutes", minutes] if minutes else ["--episodes", episodes]
        told = support.train(*arguments, *length)["lives"][0]
        with surefoot.Life(**configuration) as life:
            totals = life.run(minutes=minutes, episodes=episodes)
            self.assertEqual(life.hash, told["hash"])
            self.assertEqual((totals.steps, totals.falls), (told["steps"], told["falls"]))
        return told

    def test_pendulum_with_sarsa(self):
        told = self.same(["--seed", 5], minutes=2, seed=5)
        self.assertGreater(told["falls"], 10)

    def test_pendulum_with_two_q_functions(self):
        self.same(["--agent", "sarsa-2q", "--policy", "softmax", "--set", "policy.temperature=2"],
                  minutes=1, agent="sarsa-2q", policy="softmax", policy__temperature=2)

    def test_pendulum_with_a_threshold(self):
        self.same(["--policy", "trl", "--preset", "lab", "--scenario", "3", "--seed", 2**64 - 1],
                  minutes=1, policy="trl", preset="lab", scenario="3", seed=2**64 - 1)

    def test_compass(self):
        self.same(["--environment", "compass"], minutes=2, environment="compass")

    def test_cliff_with_a_table(self):
        self.same(["--environment", "cliff", "--features", "table", "--agent", "q-learning"],
                  episodes=200, environment="cliff", features="table", agent="q-learning")

    def test_leo(self):
        self.same(["--environment", "leo"], minutes=1, environment="leo")

    def test_a_robot_of_a_file(self):
        robot = support.ROBOTS / "hopper.toml"
        self.same(["--environment", robot], minutes=0.5, environment=robot)

    def test_a_robot_that_a_program_moves(self):
        robot = support.ROBOTS / "child" / "car.toml"
        with self.refused(surefoot.UnansweredError, "Nobody has allowed it"):
            with surefoot.Life(environment=robot) as life:
                life.run(steps=10)
        told = support.train("--environment", robot, "--allow-programs", "--episodes", 2)["lives"]
        with surefoot.Life(environment=robot, programs=True) as life:
            life.run(episodes=2)
            self.assertEqual(life.hash, told[0]["hash"])

    def test_in_pieces_as_in_one(self):
        with surefoot.Life(seed=3) as whole, surefoot.Life(seed=3) as pieces:
            whole.run(minutes=1)
            for _ in range(4):
                pieces.run(minutes=0.25)
            self.assertEqual(whole.hash, pieces.hash)
            self.assertEqual(whole.totals, pieces.totals)

    def test_looking_changes_nothing(self):
        with surefoot.Life(seed=3) as looked, surefoot.Life(seed=3) as alone:
            for _ in range(5):
                looked.run(steps=1000)
                looked.values(np.zeros((10, 3)))
                looked.probabilities([0.1, 0, 0])
                looked.visits([0.1, 0, 0])
                looked.episodes(), looked.about, looked.totals, looked.hash
            alone.run(steps=5000)
            self.assertEqual(looked.hash, alone.hash)

    def test_life_number_and_start(self):
        with surefoot.Life(seed=3, life=1) as second, surefoot.Life(seed=3) as first:
            self.assertNotEqual(second.run(minutes=.2), first.run(minutes=.2))
            told = support.train("--seed", 3, "--lives", 2, "--minutes", 0.2)["lives"]
            self.assertEqual([first.hash, second.hash], [t["hash"] for t in told])
            file = self.folder / "q.safetensors"
            first.save(file)
        told = support.train("--load", file, "--minutes", 0.2)["lives"][0]
        with surefoot.Life(load=file) as life:
            life.run(minutes=0.2)
            self.assertEqual(life.hash, told["hash"])

    def test_a_checkpoint_goes_on(self):
        file = self.folder / "life.safetensors"
        with surefoot.Life(seed=4) as life:
            life.run(steps=3210)
            life.checkpoint(file)
            life.run(steps=3000)
            with surefoot.resume(file) as again:
                self.assertEqual(again.totals.steps, 3210)
                again.run(steps=3000)
                self.assertEqual(life.hash, again.hash)
            life.checkpoint(file)  # replaced
            with surefoot.resume(file) as again:
                self.assertEqual(life.hash, again.hash)


if __name__ == "__main__":
    unittest.main()
