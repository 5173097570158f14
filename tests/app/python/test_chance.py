# SPDX-License-Identifier: GPL-3.0-or-later
"""Thousands of calls by chance: never a crash."""

import os
import random
import unittest

import support
import surefoot
from support import np

CALLS = int(os.environ.get("SUREFOOT_RANDOM_CALLS", 10_000))


class Chance(support.Folder):
    """Calls by chance with arguments of every kind. Only this package's errors may come out."""

    def test_calls(self):
        chance = random.Random(int(os.environ.get("SUREFOOT_RANDOM_SEED", 1)))
        file = str(self.folder / "q.safetensors")
        with surefoot.Life(seed=1) as life:
            life.run(steps=2000)
            life.save(file)
            life.checkpoint(str(self.folder / "life.safetensors"))
        things = []
        counts = {"fine": 0, "refused": 0}
        for number in range(CALLS):
            self.one_call(chance, things, file, number, counts)
        self.assertGreater(counts["fine"], CALLS / 10)
        self.assertGreater(counts["refused"], CALLS / 10)

    def value(self, chance):
        return chance.choice([
            lambda: None, lambda: chance.randint(-3, 6), lambda: chance.uniform(-2, 2),
            lambda: 2**chance.randint(20, 90), lambda: float("nan"), lambda: float("-inf"),
            lambda: "", lambda: "pendulum", lambda: "softmax", lambda: "a\0b", lambda: "\ud800",
            lambda: b"bytes", lambda: [], lambda: [1, 2, 3], lambda: {}, lambda: {"state": [0] * 3},
            lambda: object(), lambda: True, lambda: np.zeros(chance.randint(0, 4)),
            lambda: np.zeros((2, 3)), lambda: np.full(3, np.nan), lambda: np.int64(2),
            lambda: np.float32(0.5), lambda: np.array(["x"]), lambda: lambda *a: None,
            lambda: "x" * 10_000, lambda: "policy.epsilon", lambda: {"policy.epsilon": 0.2},
            lambda: [[1], [1, 2]], lambda: 1j, lambda: "cliff", lambda: ["sum"], lambda: "sum",
            lambda: chance.uniform(0, 1)])()

    def one_call(self, chance, things, file, number, counts):
        arguments = [self.value(chance) for _ in range(chance.randint(0, 2))]
        names = ["preset", "scenario", "render_mode", "parameters", "seed", "options", "damping",
                 "steps", "episodes", "minutes", "policy", "agent", "layer", "autoreset", "life",
                 "max_steps", "features__tilings", "task", "environment"]
        keywords = {chance.choice(names): self.value(chance)
                    for _ in range(chance.choice([0, 0, 0, 1, 2]))}
        if len(things) < 4 or chance.random() < 0.05:
            call = chance.choice([surefoot.make, surefoot.make_vec, surefoot.Life, surefoot.load])
            usual = {surefoot.make: [["pendulum"], ["cliff"], ["compass"]],
                     surefoot.make_vec: [["pendulum", 3], ["cliff", 2]],
                     surefoot.Life: [[], [{"environment": "cliff"}]],
                     surefoot.load: [[file]]}[call]
            if chance.random() < 0.7:
                arguments, keywords = chance.choice(usual), {}
        else:
            thing = chance.choice(things)
            methods = [m for m in dir(type(thing)) if not m.startswith("_") and
                       m not in ("np_random", "get_wrapper_attr", "set_wrapper_attr",
                                 "has_wrapper_attr", "close_extras", "metadata")]
            method = chance.choice(methods)
            if method == "close" and chance.random() < 0.8:
                method = "about"
            value = getattr(type(thing), method)
            if not callable(value):
                arguments, keywords = [], {}

                def call():
                    return getattr(thing, method)
            else:
                call = getattr(thing, method)
                usual = {"step": [[1], [np.array([0, 1, 2])], [[0, 0]]], "reset": [[]],
                         "values": [[[0.1, 0, 0]], [np.zeros((4, 3))], [[1, 1]]],
                         "probabilities": [[[0.1, 0, 0]], [np.zeros((4, 3))]],
                         "visits": [[[0.1, 0, 0]]], "push": [[0.01]], "place": [[[0.1, 0, 0]]],
                         "set": [["policy.epsilon", 0.1], ["damping", 0.1]],
                         "follow": [["softmax"]], "draw": [[]], "signals": [[]],
                         "episodes": [[]], "hand_made": [[]], "render": [[]],
                         "save": [[str(self.folder / str(number))]],
                         "checkpoint": [[str(self.folder / "life.safetensors")]]}
                if method == "run":
                    arguments, keywords = [], {"steps": chance.randint(-1, 50)}
                elif method in ("save", "checkpoint") or \
                        method in usual and chance.random() < 0.6:
                    arguments, keywords = chance.choice(usual[method]), {}
        try:
            made = call(*arguments, **keywords)
            counts["fine"] += 1
        except surefoot.Error as error:
            self.assertGreater(len(str(error)), 10)
            counts["refused"] += 1
            return
        except TypeError as error:
            if "argument" not in str(error):  # of Python: a call with other arguments
                raise
            counts["refused"] += 1
            return
        if isinstance(made, (surefoot.Environment, surefoot.VectorEnvironment, surefoot.Life,
                             surefoot.QFunction)) and made not in things:
            things.append(made)
            if len(things) > 8:
                del things[chance.randrange(len(things))]


if __name__ == "__main__":
    unittest.main()
