# SPDX-License-Identifier: GPL-3.0-or-later
"""The notebooks run as scripts, in short, and say what they are meant to say."""

import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

import support

NOTEBOOKS = support.SOURCE / "app" / "python" / "notebooks"


class Notebooks(support.Folder):
    def run_notebook(self, name, **settings):
        env = {**os.environ, "PICTURES": str(self.folder), "MPLBACKEND": "Agg", **settings}
        done = subprocess.run([sys.executable, str(NOTEBOOKS / name)], capture_output=True,
                              text=True, timeout=300, env=env)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_all_are_here(self):
        tested = re.findall(r'run_notebook\("(\w+\.py)"',
                            Path(__file__).read_text(encoding="utf-8"))
        self.assertEqual(sorted(tested), sorted(p.name for p in NOTEBOOKS.glob("*.py")))

    def test_first_steps(self):
        out = self.run_notebook("first_steps.py", MINUTES="1")
        self.assertRegex(out, r"By chance it falls \d+ times in 2000 steps")
        hash_there = re.search(r"hash (\w{16})", out)[1]
        self.assertEqual(support.train("--minutes", 1)["lives"][0]["hash"], hash_there)
        self.assertIn("(101, 101, 5)", out)

    def test_own_experiment(self):
        out = self.run_notebook("own_experiment.py", LIVES="3", MINUTES="0.5")
        self.assertRegex(out, r"ε-greedy +\d+\.\d falls \(\d+\.\d … \d+\.\d\)")
        self.assertEqual(len(re.findall("falls after 0.25 min", out)), 4)

    def test_own_agent(self):
        out = self.run_notebook("own_agent.py", MINUTES="1.5", LEO_MINUTES="0.5")
        first, second = map(int, re.search(r"pendulum, yours +(\d+) +(\d+)", out).groups())
        self.assertGreater(first, 20)
        self.assertRegex(out, r"LEO, Surefoot's +\d+ +\d+")

    def test_own_world(self):
        out = self.run_notebook("own_world.py", MINUTES="10")
        for name, first, second in re.findall(r"(\S+) +\d+ episodes: (\d+) falls in the first "
                                              r"half, (\d+) in the second", out):
            self.assertLess(int(second), int(first), name)


if __name__ == "__main__":
    unittest.main()
