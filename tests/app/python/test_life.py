# SPDX-License-Identifier: GPL-3.0-or-later
"""Lives and Q-functions: what they tell, and what they refuse."""

import unittest

import support
import surefoot
from support import np


class Lives(support.Folder):
    def test_so_much_further(self):
        with surefoot.Life(seed=1) as life:
            self.assertEqual(life.run(steps=100).steps, 100)
            self.assertEqual(life.run(steps=50).steps, 150)
            episodes = life.run(episodes=10).episodes
            self.assertEqual(life.run(episodes=5).episodes, episodes + 5)
            before = life.totals
            after = life.run(minutes=0.1)
            self.assertAlmostEqual(after.simulated_minutes, before.simulated_minutes + 0.1, 6)
            self.assertEqual(life.run(steps=10, episodes=1000).steps, after.steps + 10)
            self.assertEqual(life.totals, life.totals)

    def test_episodes(self):
        with surefoot.Life(seed=1) as life:
            self.assertEqual(len(life.episodes()), 0)
            totals = life.run(minutes=1)
            rows = life.episodes()
            self.assertEqual(len(rows), totals.episodes)
            np.testing.assert_array_equal(rows["episode"], np.arange(1, len(rows) + 1))
            np.testing.assert_array_equal(rows["steps"], np.cumsum(rows["transitions"]))
            np.testing.assert_allclose(rows["minutes"], rows["steps"] * 0.005 / 60)
            self.assertEqual(rows["falls"].sum(), totals.falls)
            self.assertEqual((rows["ending"] == "fall").sum(), totals.falls)
            self.assertEqual((rows["ending"] == "success").sum(), totals.successes)
            np.testing.assert_array_equal(rows["reward"][rows["ending"] == "fall"], -100.0)
            self.assertAlmostEqual(rows["average_reward"][-1], rows["reward"][-80:].mean())
            self.assertAlmostEqual(totals.average_reward, rows["average_reward"][-1])

    def test_the_table_is_that_of_the_program(self):
        file = self.folder / "log.csv"
        told = support.train("--environment", "compass", "--minutes", 1, "--log", file)["lives"][0]
        log = np.genfromtxt(file, delimiter=",", names=True, dtype=None, encoding="utf-8")
        with surefoot.Life(environment="compass") as life:
            life.run(minutes=1)
            rows = life.episodes()
        self.assertEqual(len(rows), told["episodes"])
        self.assertIn("distance", rows.dtype.names)
        common = [n for n in log.dtype.names if n in rows.dtype.names and n != "ending"]
        self.assertGreaterEqual(len(common), 5)
        for name in common:
            with self.subTest(column=name):
                np.testing.assert_allclose(rows[name], log[name], rtol=1e-8, atol=1e-8)

    def test_values(self):
        with surefoot.Life(seed=1, agent="sarsa-2q") as life:
            life.run(minutes=0.5)
            one = life.values([0.1, 0.2, 0.3])
            self.assertEqual((one.shape, one.dtype), ((5,), np.float64))
            states = np.random.default_rng(1).uniform(-1, 1, (4, 6, 3))
            q = life.values(states)
            self.assertEqual(q.shape, (4, 6, 5))
            np.testing.assert_array_equal(q[2, 3], life.values(states[2, 3]))
            np.testing.assert_allclose(q, life.values(states, "positive") +
                                       life.values(states, layer="negative"), atol=1e-9)
            np.testing.assert_array_equal(life.values(states[:, ::2]), q[:, ::2])
            np.testing.assert_array_equal(life.values(np.asfortranarray(states)), q)
            self.assertEqual(life.values(np.zeros((0, 3))).shape, (0, 5))
            pi = life.probabilities(states)
            np.testing.assert_allclose(pi.sum(-1), 1, atol=1e-12)
            np.testing.assert_array_equal(pi.argmax(-1), q.argmax(-1))
            visits = life.visits(states)
            self.assertEqual(visits.shape, (4, 6))
            self.assertGreater(life.visits([0.0, 0, 0]), life.visits([1.0, -10, 20]))
            for states in (0.1, [0.1, 0.2], np.zeros((3, 2)), np.zeros(())):
                with self.refused(surefoot.UsageError, "shape"):
                    life.values(states)
            for states in ("xyz", None, ["a", "b", "c"], [[1, 2, 3], [1]], [1j, 0, 0]):
                with self.refused(TypeError):
                    life.values(states)
            for number in (np.nan, np.inf):
                with self.refused(surefoot.UsageError, "finite"):
                    life.probabilities([0, 0, number])
            for layer in ("summ", None, 7, "risk"):
                with self.refused(surefoot.UsageError, "layer"):
                    life.values([0, 0, 0], layer)

    def test_commands(self):
        with surefoot.Life(seed=1) as life:
            life.run(steps=1000)
            life.set("policy.epsilon", 0.5)
            pi = life.probabilities([0.1, 0, 0])
            self.assertAlmostEqual(pi.min(), 0.1)
            life.follow("softmax")
            self.assertGreater(life.probabilities([0.1, 0, 0]).min(), 0)
            life.push(0.05)
            life.place([0.1, 0, 0])
            life.run(steps=10)
            for call, word in ((lambda: life.set("policy.epsilonn", 0.5), "epsilon"),
                               (lambda: life.set("policy.epsilon", 2), "epsilon"),
                               (lambda: life.set("policy.epsilon", "much"), "epsilon"),
                               (lambda: life.follow("soft"), "soft"),
                               (lambda: life.push(np.inf), "finite"),
                               (lambda: life.place([9, 0, 0]), "angle"),
                               (lambda: life.place([0, 0]), "3")):
                with self.refused(surefoot.UsageError, word):
                    call()
            for call in (lambda: life.set(None, 1), lambda: life.set("policy.epsilon", [1]),
                         lambda: life.follow(3), lambda: life.push("hard"),
                         lambda: life.place("here")):
                with self.refused(TypeError):
                    call()

    def test_the_same_commands_as_the_program(self):
        told = support.train("--minutes", 0.5, "--at", "2000:policy.epsilon=0.2",
                             "--at", "3000:push=0.05", "--at", "4000:policy=softmax")["lives"][0]
        with surefoot.Life() as life:
            life.run(steps=2000)
            life.set("policy.epsilon", 0.2)
            life.run(steps=1000)
            life.push(0.05)
            life.run(steps=1000)
            life.follow("softmax")
            life.run(steps=2000)
            self.assertEqual(life.hash, told["hash"])

    def test_about(self):
        with surefoot.Life({"environment": "pendulum", "parameters": {"policy.epsilon": 0.1}},
                           policy__epsilon=0.2, seed=7, scenario="2") as life:
            about = life.about
            self.assertEqual(about["seed"], 7)
            self.assertEqual(about["configuration"]["scenario"], "2")
            self.assertEqual(about["configuration"]["parameters"]["policy.epsilon"], 0.2)
            self.assertEqual(life.task["environment"], "pendulum")
            self.assertIn("0 steps", repr(life))
        with surefoot.Life(environment="cliff", features="table") as life:
            self.assertIsNone(life.run(episodes=3).simulated_minutes)
            self.assertTrue(np.isnan(life.episodes()["minutes"]).all())
            with self.refused(surefoot.UsageError, "clock"):
                life.run(minutes=1)

    def test_wrong_configurations(self):
        for wrong in ({"agent": "sarsaa"}, {"polizy": "trl"}, {"seed": -1}, {"seed": 2**64},
                      {"life": -1}, {"load": "nothing.safetensors"}, {"preset": "none"},
                      {"policy.epsilon": 1}, {"parameters": {"policy.epsilon": 7}},
                      {"parameters": {"policy.epsilon": float("nan")}}, {"environment": "x\0"},
                      {"parameters": {"a": {}}}, {"resume": "nothing.safetensors"}):
            with self.subTest(wrong), self.refused(surefoot.Error):
                surefoot.Life(wrong)
        for wrong in (3, "pendulum", [1]):
            with self.refused(TypeError):
                surefoot.Life(wrong)
        for wrong in ({"seed": 1.5}, {"seed": "1"}, {"policy": 3}, {"parameters": 3},
                      {"epsilon": 0.1}, {"environment": 7}):
            with self.subTest(wrong), self.refused(surefoot.Error):
                surefoot.Life(**wrong)
        loop = {}
        loop["parameters"] = loop
        with self.refused(surefoot.Error):
            surefoot.Life(loop)
        with surefoot.Life() as life:
            for wrong in ({}, {"steps": 0}, {"steps": -1}, {"minutes": 0}, {"minutes": np.nan},
                          {"minutes": 1e300}, {"episodes": 1.5}, {"steps": 2**70},
                          {"steps": "3"}):
                with self.subTest(wrong), self.refused(surefoot.Error):
                    life.run(**wrong)
            self.assertEqual(life.totals.steps, 0)

    def test_a_life_that_diverged_can_be_asked(self):
        with surefoot.Life(environment="mountain-car", agent__step_size=1.9,
                           agent__trace="accumulating", agent__trace_decay=0.99) as life:
            with self.refused(surefoot.DivergedError):
                for _ in range(200):
                    life.run(steps=100_000)
            self.assertGreater(life.totals.steps, 0)
            life.episodes()

    def test_closed(self):
        life = surefoot.Life()
        life.close()
        life.close()
        for call in (lambda: life.run(steps=1), lambda: life.values([0, 0, 0]), life.episodes,
                     lambda: life.hash, lambda: life.about, lambda: life.save("x"),
                     lambda: life.totals):
            with self.refused(surefoot.UsageError, "closed"):
                call()


class Files(support.Folder):
    def test_a_q_function(self):
        file = self.folder / "q ü.safetensors"
        with surefoot.Life(seed=1) as life:
            life.run(minutes=0.5)
            life.save(file)
            states = np.random.default_rng(1).uniform(-1, 1, (50, 3))
            with self.refused(surefoot.FileError):
                life.save(file)
            with surefoot.load(str(file)) as q:
                np.testing.assert_allclose(q.values(states), life.values(states), rtol=1e-12)
                np.testing.assert_array_equal(q.probabilities(states), life.probabilities(states))
                np.testing.assert_array_equal(q.visits(states), life.visits(states))
                about = q.about
                self.assertEqual(about["configuration"]["environment"], "pendulum")
                self.assertEqual(about["layers"], ["sum"])
                soft = q.probabilities(states, "softmax", policy__temperature=0.5)
                values = q.values(states) / 0.5
                expected = np.exp(values - values.max(-1, keepdims=True))
                expected /= expected.sum(-1, keepdims=True)
                np.testing.assert_allclose(soft, expected, rtol=1e-9, atol=1e-12)
                np.testing.assert_array_equal(q.probabilities(states), life.probabilities(states))
                for call in (lambda: q.probabilities(states, "soft"),
                             lambda: q.probabilities(states, "softmax", policy__temperature=-1),
                             lambda: q.probabilities(states, 3),
                             lambda: q.values(states, "risk"), lambda: q.values([1, 2])):
                    with self.refused(surefoot.Error):
                        call()
            with self.refused(surefoot.UsageError, "closed"):
                q.values(states)

    def test_what_is_no_file_of_ours(self):
        junk = self.folder / "junk.safetensors"
        junk.write_bytes(b"\x08\0\0\0\0\0\0\0{\"a\": 1}")
        whole = self.folder / "whole.safetensors"
        with surefoot.Life(seed=1) as life:
            life.run(steps=500)
            life.save(whole)
            life.checkpoint(self.folder / "life.safetensors")
            with self.refused(OSError):
                life.save(self.folder / "no" / "q.safetensors")
            with self.refused(OSError):
                life.checkpoint(self.folder / "no" / "life.safetensors")
        cut = self.folder / "cut.safetensors"
        cut.write_bytes(whole.read_bytes()[:-100])
        for file in (junk, cut, self.folder, self.folder / "none", "/dev/null"):
            for call in (surefoot.load, surefoot.resume, surefoot.statistics, surefoot.episodes,
                         surefoot.lives, surefoot.conditions):
                with self.subTest(file=str(file), call=call.__name__), \
                        self.refused(surefoot.Error):
                    call(file)
        with self.refused(surefoot.Error):
            surefoot.resume(whole)  # a Q-function is no life
        for wrong in (None, 3, "", b"", "a\0b", [1]):
            with self.subTest(wrong), self.refused(surefoot.Error):
                surefoot.load(wrong)

    def test_of_another_version(self):
        file = self.folder / "life.safetensors"
        with surefoot.Life(seed=1) as life:
            life.run(steps=500)
            life.checkpoint(file)
        data = file.read_bytes()
        size = int.from_bytes(data[:8], "little")
        header = data[8:8 + size]
        for key in (b'\\"lives_version\\":', b'\\"version\\":\\"', b'\\"lives\\":'):
            at = header.find(key)
            if at >= 0:
                break
        self.assertGreaterEqual(at, 0, header[:300])
        at += len(key)
        while not chr(header[at]).isdigit():
            at += 1
        changed = header[:at] + (b"9" if header[at:at + 1] != b"9" else b"8") + header[at + 1:]
        other = self.folder / "other.safetensors"
        other.write_bytes(data[:8] + changed + data[8 + size:])
        with self.refused(surefoot.Error):
            surefoot.resume(other)


if __name__ == "__main__":
    unittest.main()
