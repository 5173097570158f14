# SPDX-License-Identifier: GPL-3.0-or-later
"""Steps a second from Python, with actions by chance: python3 tests/bench/python_steps.py

Beside them Gymnasium's CartPole, where it is installed. PYTHONPATH=app/python.
"""

import statistics
import sys
import time

import numpy as np

import surefoot


def one_by_one(env, steps=50_000):
    """As a script would: an action, a step, a reset when it is over."""
    number = int(env.action_space.n)
    actions = np.random.default_rng(1).integers(0, number, steps).tolist()
    env.reset(seed=1)
    begun = time.perf_counter()
    for action in actions:
        _, _, terminated, truncated, _ = env.step(action)
        if terminated or truncated:
            env.reset()
    return steps / (time.perf_counter() - begun)


def together(envs, calls):
    """All of a vector environment in a call."""
    number = int(envs.single_action_space.n)
    actions = np.random.default_rng(1).integers(0, number, (calls, envs.num_envs))
    envs.reset(seed=1)
    begun = time.perf_counter()
    for row in actions:
        envs.step(row)
    return calls * envs.num_envs / (time.perf_counter() - begun)


def life(minutes=20):
    """A life of the library's, for comparison: nothing of Python in its steps."""
    with surefoot.Life(seed=1) as lived:
        begun = time.perf_counter()
        steps = lived.run(minutes=minutes).steps
        return steps / (time.perf_counter() - begun)


CASES = {
    "pendulum, one by one": lambda: one_by_one(surefoot.make("pendulum")),
    "pendulum, 16 at once": lambda: together(surefoot.make_vec("pendulum", 16), 5_000),
    "pendulum, 256 at once": lambda: together(surefoot.make_vec("pendulum", 256), 400),
    "cliff, one by one": lambda: one_by_one(surefoot.make("cliff")),
    "cliff, 256 at once": lambda: together(surefoot.make_vec("cliff", 256), 1_000),
    "compass, one by one": lambda: one_by_one(surefoot.make("compass")),
    "leo, one by one": lambda: one_by_one(surefoot.make("leo"), 10_000),
    "a life on the pendulum": life,
}

try:
    import gymnasium
except ImportError:
    pass
else:
    CASES["Gymnasium's CartPole, one by one"] = lambda: one_by_one(
        gymnasium.make("CartPole-v1").unwrapped)
    CASES["Gymnasium's CartPole, 256 at once"] = lambda: together(
        gymnasium.make_vec("CartPole-v1", 256, vectorization_mode="vector_entry_point"), 1_000)

if __name__ == "__main__":
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    times = {name: [] for name in CASES}
    for _ in range(rounds):
        for name, case in CASES.items():
            times[name].append(case())
    for name, rates in times.items():
        print(f"{name:34} {statistics.median(rates):10,.0f} steps/s "
              f"({min(rates):,.0f} … {max(rates):,.0f})")
