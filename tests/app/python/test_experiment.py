# SPDX-License-Identifier: GPL-3.0-or-later
"""Experiments, their results as arrays, and exports."""

import json
import os
import signal
import subprocess
import sys
import unittest

import support
import surefoot
from support import np

PLAN = """
title = "A small one"
lives = 3
[base]
environment = "pendulum"
minutes = 0.2
[[condition]]
name = "ε-greedy"
policy = "epsilon-greedy"
[[condition]]
name = "TRL"
policy = "trl"
"""


def program(*arguments):
    done = subprocess.run([support.PROGRAM, *map(str, arguments)], check=True,
                          capture_output=True, text=True)
    return done.stdout


class Experiments(support.Folder):
    def run_plan(self, name="a.sqlite", plan=PLAN, **options):
        return surefoot.experiment(plan, self.folder / name, progress=False, **options)

    def test_the_same_content_as_the_program(self):
        plan = self.folder / "plan.toml"
        plan.write_text(PLAN, encoding="utf-8")
        told = program("experiment", plan, "--out", self.folder / "p.sqlite", "--json", "--seed",
                       9, "--lives", 2, "--set", "policy.epsilon=0.1")
        expected = json.loads(told.splitlines()[-1])
        for number, (what, jobs) in enumerate(((PLAN, 1), (plan, 2), (str(plan), None))):
            store = self.run_plan(f"{number}.sqlite", what, jobs=jobs, seed=9, lives=2,
                                  policy__epsilon=0.1)
            self.assertEqual(store["content_hash"], expected["content_hash"])
            self.assertEqual((store["lives"], store["of"], store["complete"]), (4, 4, True))
        self.assertEqual(json.loads(program("statistics", self.folder / "0.sqlite", "--json")),
                         surefoot.statistics(store))

    def test_results(self):
        store = self.run_plan()
        for source in (store, store["store"], self.folder / "a.sqlite"):
            self.assertEqual(surefoot.statistics(source)["title"], "A small one")
        there = surefoot.conditions(store)
        self.assertEqual([c["name"] for c in there], ["ε-greedy", "TRL"])
        lives = surefoot.lives(store)
        self.assertEqual(len(lives), 6)
        rows = surefoot.episodes(store)
        for life in lives:
            mine = rows[(rows["condition"] == life["condition"]) & (rows["life"] == life["life"])]
            self.assertEqual(len(mine), life["episodes"])
            self.assertEqual(mine["falls"].sum(), life["falls"])
            self.assertTrue((np.diff(mine["steps"]) == mine["transitions"][1:]).all())
            np.testing.assert_array_equal(
                mine, surefoot.episodes(store, int(life["condition"]), int(life["life"])))
        trl = surefoot.episodes(store, "TRL")
        np.testing.assert_array_equal(trl, rows[rows["condition"] == 1])
        folder = self.folder / "csv"
        program("export", self.folder / "a.sqlite", "--csv", folder)
        csv = np.genfromtxt(folder / "episodes.csv", delimiter=",", names=True, dtype=None,
                            encoding="utf-8")
        self.assertEqual(len(csv), len(rows))
        for name in ("condition", "life", "episode", "transitions", "reward", "falls", "minutes"):
            np.testing.assert_allclose(rows[name], csv[name], rtol=1e-8)
        np.testing.assert_array_equal(rows["ending"], csv["ending"])
        mean = [lives["falls"][lives["condition"] == c].mean() for c in (0, 1)]
        found = [c["all_falls"]["value"] for c in surefoot.statistics(store)["conditions"]]
        np.testing.assert_allclose(found, mean)
        for call in (lambda: surefoot.episodes(store, "Nobody"),
                     lambda: surefoot.episodes(store, 2), lambda: surefoot.episodes(store, 0, 3),
                     lambda: surefoot.episodes(store, 1.5), lambda: surefoot.statistics(None),
                     lambda: surefoot.statistics({"a": 1}), lambda: surefoot.lives(3)):
            with self.refused(surefoot.Error):
                call()

    def test_frames(self):
        store = self.run_plan()
        try:
            import pandas
        except ImportError:
            with self.refused(ImportError, "pandas"):
                surefoot.frame(store)
            return
        data = surefoot.frame(store)
        self.assertIsInstance(data, pandas.DataFrame)
        self.assertEqual(set(data["name"]), {"ε-greedy", "TRL"})
        self.assertEqual(len(surefoot.frame(store, "lives")), 6)
        with surefoot.Life() as life:
            life.run(steps=1000)
            self.assertEqual(len(surefoot.frame(life)), len(life.episodes()))
        with self.refused(surefoot.UsageError):
            surefoot.frame(store, "legs")

    def test_wrong(self):
        self.run_plan()
        with self.refused(surefoot.Error, "a.sqlite"):
            self.run_plan()  # it is there
        for number, options in enumerate((
                {"plan": "no such plan"}, {"plan": "title = \n"}, {"plan": ""}, {"plan": None},
                {"plan": 3}, {"lives": 0}, {"lives": 2.5}, {"jobs": 0}, {"seed": -1},
                {"seed": 2**64}, {"policy__epsilon": 7}, {"policy__epsylon": 0.1},
                {"parameters": 3}, {"plan": PLAN.replace("trl", "trll")}, {"plan": "a\0\n"})):
            with self.subTest(options), self.refused(surefoot.Error):
                self.run_plan(f"w{number}.sqlite", **options)
            self.assertFalse((self.folder / f"w{number}.sqlite").exists())
        with self.refused(surefoot.Error):
            surefoot.experiment(PLAN, self.folder / "no" / "a.sqlite", progress=False)
        for progress in (3, "yes"):
            with self.refused(TypeError):
                surefoot.experiment(PLAN, self.folder / "b.sqlite", progress=progress)

    def test_progress(self):
        seen = []
        surefoot.experiment(PLAN, self.folder / "a.sqlite", progress=seen.append, lives=30)
        for now in seen:
            self.assertEqual(set(now), {"share", "lives", "of", "falls", "steps"})
        self.assertEqual(sorted(n["share"] for n in seen), [n["share"] for n in seen])

        def stop(now):
            raise LookupError("enough")
        with self.assertRaisesRegex(LookupError, "enough"):
            surefoot.experiment(PLAN, self.folder / "b.sqlite", progress=stop, lives=10_000)

    def test_interrupted_and_resumed(self):
        code = ("import surefoot, sys\n"
                "try:\n"
                "    surefoot.experiment(sys.stdin.read(), sys.argv[1], jobs=1,\n"
                "                        progress=lambda now: print(now['lives'], flush=True))\n"
                "except KeyboardInterrupt:\n"
                "    print('interrupted')\n")
        out = self.folder / "a.sqlite"
        child = subprocess.Popen([sys.executable, "-c", code, str(out)], text=True,
                                 stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        plan = PLAN.replace("lives = 3", "lives = 12").replace("0.2", "2")
        child.stdin.write(plan)
        child.stdin.close()
        while int(child.stdout.readline()) < 3:
            pass
        child.send_signal(signal.SIGINT)
        rest = child.stdout.read()
        self.assertEqual(child.wait(20), 0)
        child.stdout.close()
        self.assertIn("interrupted", rest)
        kept = len(surefoot.lives(out))
        self.assertTrue(3 <= kept < 24, kept)
        store = surefoot.experiment(plan, out, resume=True, progress=False)
        self.assertTrue(store["complete"])
        self.assertEqual(store["content_hash"],
                         self.run_plan("whole.sqlite", plan)["content_hash"])


class Exports(support.Folder):
    def test_a_minari_shaped_file(self):
        file = self.folder / "rolled.npz"
        with surefoot.make("pendulum") as env, surefoot.Life(seed=1) as life:
            life.run(minutes=3)
            about = surefoot.export.minari(file, env, life, count=4, seed=10)
            with np.load(file) as data:
                self.assertEqual(json.loads(str(data["metadata"])), about)
                steps = falls = 0
                for i in range(4):
                    part = {k.split("/", 1)[1]: data[k] for k in data.files
                            if k.startswith(f"episode_{i}/")}
                    n = len(part["actions"])
                    self.assertEqual(part["observations"].shape, (n + 1, 3))
                    self.assertTrue((part["terminations"] | part["truncations"])[-1])
                    self.assertFalse((part["terminations"] | part["truncations"])[:-1].any())
                    np.testing.assert_array_equal(part["observations"][0],
                                                  env.reset(seed=10 + i)[0])
                    for t in range(n):
                        state, reward, *_ = env.step(int(part["actions"][t]))
                        np.testing.assert_array_equal(part["observations"][t + 1], state)
                        self.assertEqual(part["rewards"][t], reward)
                    steps, falls = steps + n, falls + part["infos/fall"].sum()
            self.assertEqual((about["total_steps"], about["falls"]), (steps, falls))
            with self.refused(OSError, "exists"):
                surefoot.export.minari(file, env, life)
            wrong = self.folder / "wrong.npz"
            with self.assertRaises(ZeroDivisionError):
                surefoot.export.minari(wrong, env, lambda state: 1 // 0)
            for call in (lambda: surefoot.export.minari(wrong, env, 3),
                         lambda: surefoot.export.minari(wrong, "pendulum"),
                         lambda: surefoot.export.minari(wrong, env, count=0)):
                with self.refused(surefoot.Error):
                    call()
            self.assertFalse(wrong.exists())
            self.assertEqual(surefoot.export.minari(wrong, env, count=1, most_steps=5)
                             ["total_steps"], 5)

    def test_what_is_not_installed_is_told(self):
        with surefoot.Life() as life:
            life.run(steps=1000)
            for call, place, word in (
                    (surefoot.export.parquet, self.folder / "a.parquet", "pyarrow"),
                    (surefoot.export.tensorboard, self.folder / "runs", "tensorboardX")):
                try:
                    call(life, place)
                except surefoot.MissingError as error:
                    self.assertIn(word, str(error))
                else:
                    self.assertTrue(place.exists())

    def test_tensorboard_gets_every_life(self):
        """With a writer of our own in place of tensorboardX."""
        written = {}

        class Writer:
            def __init__(self, folder):
                self.rows = written.setdefault(os.path.relpath(folder, support.SOURCE), [])

            def add_scalar(self, name, value, step):
                self.rows.append((name, value, step))

            def close(self):
                self.rows.append("closed")
        from types import ModuleType
        module = ModuleType("tensorboardX")
        module.SummaryWriter = Writer
        sys.modules["tensorboardX"] = module
        self.addCleanup(sys.modules.pop, "tensorboardX")
        store = surefoot.experiment(PLAN, self.folder / "a.sqlite", progress=False)
        surefoot.export.tensorboard(store, self.folder / "runs")
        self.assertEqual(len(written), 6)
        rows = surefoot.episodes(store, 1, 2)
        mine = next(r for f, r in written.items() if f.endswith(os.path.join("1 TRL", "2")))
        self.assertEqual(mine[-1], "closed")
        self.assertEqual(mine[-2], ("falls", rows["falls"].sum(), rows["steps"][-1]))
        self.assertEqual(mine[0], ("reward", rows["reward"][0], rows["steps"][0]))

    def test_list_all(self):
        told = surefoot.list_all()
        self.assertEqual(told, json.loads(program("list", "--json")))
        self.assertIn("pendulum", [e["name"] for e in told["environments"]])


if __name__ == "__main__":
    unittest.main()
