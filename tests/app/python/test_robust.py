# SPDX-License-Identifier: GPL-3.0-or-later
"""Threads, Ctrl-C, the interpreter's end: never a crash."""

import signal
import subprocess
import sys
import threading
import time
import unittest

import support
import surefoot
from support import np


class Threads(support.Folder):
    def test_two_in_one_life(self):
        with surefoot.Life(environment="leo") as life:
            told = []

            def run():
                told.append(life.run(steps=40_000).steps)
            thread = threading.Thread(target=run)
            thread.start()
            refused = 0
            while thread.is_alive():
                try:
                    life.values(np.zeros(10))
                except surefoot.BusyError as error:
                    self.assertIn("one thread at a time", str(error))
                    refused += 1
                    with self.refused(surefoot.BusyError):
                        life.close()
                    break
            thread.join()
            self.assertEqual(told, [40_000])
            self.assertEqual(refused, 1)
            life.values(np.zeros(10))

    def test_two_in_one_environment(self):
        env = surefoot.make("pendulum")
        env.reset(seed=1)
        strange = []

        def play():
            for _ in range(3000):
                try:
                    if any(env.step(2)[2:4]):
                        env.reset()
                except (surefoot.BusyError, surefoot.UsageError):
                    pass
                except BaseException as error:
                    strange.append(error)
        threads = [threading.Thread(target=play) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(strange, [])
        env.close()

    def test_each_its_own(self):
        """Lives in threads of their own give the bits that they give alone."""
        hashes = {}

        def live(seed):
            with surefoot.Life(seed=seed) as life:
                life.run(steps=5000)
                hashes[seed] = life.hash
        threads = [threading.Thread(target=live, args=(seed,)) for seed in range(6)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        together = dict(hashes)
        for seed in range(6):
            live(seed)
        self.assertEqual(hashes, together)

    def test_others_run_while_a_life_does(self):
        with surefoot.Life() as life:
            thread = threading.Thread(target=lambda: life.run(steps=300_000))
            thread.start()
            ticks = 0
            while thread.is_alive():
                ticks += 1
                time.sleep(0.001)
            self.assertGreater(ticks, 20)


class Interrupts(support.Folder):
    def interrupted(self, code, after=1):
        """What a child prints that gets SIGINT when it has printed so many lines."""
        child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, text=True)
        lines = [child.stdout.readline() for _ in range(after)]
        time.sleep(0.3)
        child.send_signal(signal.SIGINT)
        out, err = child.communicate(timeout=30)
        self.assertEqual(child.returncode, 0, err)
        return "".join(lines) + out

    def test_a_life_stops_between_two_steps(self):
        out = self.interrupted(
            "import surefoot, time\n"
            "life = surefoot.Life(seed=1)\n"
            "print('begun', flush=True)\n"
            "try:\n"
            "    life.run(minutes=1e6)\n"
            "except KeyboardInterrupt:\n"
            "    n = life.totals.steps\n"
            "    other = surefoot.Life(seed=1); other.run(steps=n)\n"
            "    print('kept', n > 0, life.hash == other.hash)\n"
            "    print('on', life.run(steps=10).steps == n + 10)\n")
        self.assertIn("kept True True\non True", out)

    def test_a_world_in_python_is_not_torn(self):
        out = self.interrupted(
            "import surefoot\n"
            "class World:\n"
            "    task = {'state': [{'key': 'x', 'low': 0, 'high': 9}], 'actions': [0, 1]}\n"
            "    steps = 0\n"
            "    def reset(self, seed): self.x = 0; return [0]\n"
            "    def step(self, action):\n"
            "        self.steps += 1; self.x = (self.x + 1) % 10\n"
            "        return [self.x], 1.0, self.x == 0, False, {}\n"
            "world = World()\n"
            "life = surefoot.Life(environment=world)\n"
            "print('begun', flush=True)\n"
            "try:\n"
            "    life.run(steps=10**9)\n"
            "except KeyboardInterrupt:\n"
            "    print('same', life.totals.steps == world.steps)\n"
            "    life.run(steps=10)\n"
            "    print('same', life.totals.steps == world.steps)\n")
        self.assertIn("same True\nsame True", out)

    def test_a_world_that_hangs(self):
        code = ("import surefoot, time\n"
                "class World:\n"
                "    task = {'state': [{'key': 'x', 'low': 0, 'high': 9}], 'actions': [0, 1]}\n"
                "    def reset(self, seed): return [0]\n"
                "    def step(self, action):\n"
                "        print('hangs', flush=True)\n"
                "        while True: time.sleep(0.01)\n"
                "life = surefoot.Life(environment=World())\n"
                "try:\n"
                "    life.run(steps=10)\n"
                "except KeyboardInterrupt:\n"
                "    print('free', life.totals.steps)\n")
        child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
        child.stdout.readline()
        for _ in range(2):
            time.sleep(0.3)
            child.send_signal(signal.SIGINT)
        out, _ = child.communicate(timeout=30)
        self.assertEqual((child.returncode, out), (0, "free 0\n"))

    def test_the_handler_is_put_back(self):
        before = signal.getsignal(signal.SIGINT)
        with surefoot.Life() as life:
            life.run(steps=10)
            self.assertIs(signal.getsignal(signal.SIGINT), before)
            with self.assertRaises(surefoot.Error):
                life.run(steps=-1)
        self.assertIs(signal.getsignal(signal.SIGINT), before)


class Endings(support.Folder):
    """An interpreter that ends while daemon threads are inside the library."""

    def ends(self, code):
        done = support.python("import surefoot, threading, time, sys\n" + code +
                              "\nprint('over', flush=True)\n", timeout=60)
        self.assertEqual((done.returncode, done.stdout), (0, "over\n"), done.stderr)
        self.assertEqual(done.stderr, "")

    def daemon(self, what):
        return (what + "\nfor _ in range(3): threading.Thread(target=go, daemon=True).start()\n"
                "time.sleep(0.5)\n")

    def test_lives(self):
        self.ends(self.daemon("def go():\n    surefoot.Life().run(minutes=1e6)"))

    def test_worlds_in_python(self):
        self.ends(self.daemon(
            "class World:\n"
            "    task = {'state': [{'key': 'x', 'low': 0, 'high': 9}], 'actions': [0, 1]}\n"
            "    def reset(self, seed): return [0]\n"
            "    def step(self, action): return [0], 1.0, False, False, {}\n"
            "def go():\n"
            "    surefoot.Life(environment=World(), policy=lambda q: q * 0 + 1).run(steps=10**9)"))

    def test_experiments(self):
        self.ends(
            "go = lambda: surefoot.experiment('[base]\\nminutes = 1e5\\n[[condition]]\\n"
            "policy = \"trl\"\\n', "
            f"{str(self.folder / 'a.sqlite')!r}, jobs=1, lives=2, progress=False)\n"
            "threading.Thread(target=go, daemon=True).start()\ntime.sleep(1)\n")

    def test_environments(self):
        self.ends(self.daemon(
            "def go():\n"
            "    env = surefoot.make('pendulum'); env.reset(seed=1)\n"
            "    while True:\n"
            "        if any(env.step(1)[2:4]): env.reset()\n"))
        self.ends(self.daemon(
            "def go():\n"
            "    envs = surefoot.make_vec('pendulum', 100); envs.reset(seed=1)\n"
            "    while True: envs.step(envs.action_space.sample())\n"))

    def test_open_things(self):
        self.ends("class A: pass\na = A(); a.a = a; a.env = surefoot.make('pendulum')\n"
                  "life = surefoot.Life(policy=lambda q: q * 0 + 1); life.run(steps=100)\n"
                  "import atexit; atexit.register(lambda: (life.close(), a.env.close()))\n")

    def test_thousands_of_handles(self):
        for _ in range(300):
            surefoot.make("pendulum").reset(seed=1)
            surefoot.Life(environment="cliff", features="table")


if __name__ == "__main__":
    unittest.main()
