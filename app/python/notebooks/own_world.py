# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# A world of one's own in Python, learned by Surefoot's Sarsa: a ball on a board that tilts. It
# should lie still in the middle; over the edge is a fall.
#
# MINUTES (of the life, simulated) changes it. For the window the same world is a program of its
# own: see resources/robots/child/car.toml and car.py.

# %%
import math
import os
import random

import numpy as np

import surefoot

MINUTES = float(os.environ.get("MINUTES", 20))


# %%
class BallOnBoard:
    """A ball rolls on a board of 1 m; an action tilts the board for a tenth of a second."""

    TILTS = [-0.1, -0.03, 0.0, 0.03, 0.1]  # rad
    task = {
        "title": "ball on a board",
        "state": [{"key": "x", "unit": "m", "low": -0.5, "high": 0.5},
                  {"key": "v", "unit": "m/s", "low": -1.0, "high": 1.0}],
        "actions": TILTS, "action_title": "tilt", "action_unit": "rad",
        "step_time": 0.1, "goal_reward": 10.0, "can_fall": True,
    }

    def reset(self, seed):
        """All chance comes from `seed`."""
        chance = random.Random(seed)
        self.x, self.v = chance.uniform(-0.3, 0.3), chance.uniform(-0.2, 0.2)
        self.steps = 0
        return [self.x, self.v]

    def step(self, action):
        """State, reward, terminated, truncated, what happened."""
        acceleration = -9.81 * 5 / 7 * math.sin(self.TILTS[action])
        self.x += 0.1 * self.v + 0.005 * acceleration
        self.v += 0.1 * acceleration
        self.steps += 1
        fall = abs(self.x) > 0.5
        success = abs(self.x) < 0.05 and abs(self.v) < 0.05
        reward = -10.0 if fall else 10.0 if success else -0.1
        return ([self.x, self.v], reward, fall or success, self.steps >= 300,
                {"fall": fall, "success": success})


# %%
def softmax(q):
    """A policy of one's own: probabilities from the values of the actions."""
    p = np.exp(q - q.max())
    return p / p.sum()


for policy in ("epsilon-greedy", softmax):
    with surefoot.Life(environment=BallOnBoard(), policy=policy, seed=1) as life:
        life.run(minutes=MINUTES, progress=True)  # tells how fast Python's world is
        episodes = life.episodes()
        half = len(episodes) // 2
        first, second = (int(part["falls"].sum()) for part in (episodes[:half], episodes[half:]))
        print(f"{getattr(policy, '__name__', policy):15} {len(episodes)} episodes: {first} falls "
              f"in the first half, {second} in the second; "
              f"{(episodes['ending'][half:] == 'success').mean():.0%} of the second succeed")
