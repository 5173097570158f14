# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# An agent of one's own: Sarsa(λ) with tile coding in NumPy, on the pendulum and on the robot LEO,
# beside Surefoot's own Sarsa, with the falls of both in one table.
#
# MINUTES (on the pendulum, simulated), LEO_MINUTES and PICTURES (a folder) change it.

# %%
import os
import time
from pathlib import Path

import numpy as np

import surefoot

MINUTES = float(os.environ.get("MINUTES", 9))
LEO_MINUTES = float(os.environ.get("LEO_MINUTES", 60))
PICTURES = Path(os.environ.get("PICTURES", "."))


# %%
class Sarsa:
    """Sarsa(λ) with replacing traces; q̂ is linear in hashed tiles (Sutton & Barto, chapter 12)."""

    def __init__(self, ranges, actions, tiles, *, tilings=16, memory=2**16, step_size=0.4,
                 discount=0.98, trace_decay=0.92, epsilon=0.05, initial=0.1, seed=1):
        self.low, self.scale = ranges[0], tiles / (ranges[1] - ranges[0])
        self.top, self.actions = np.asarray(tiles) - 1e-9, actions
        self.random = np.random.default_rng(seed)
        d = len(self.low)
        tiling = np.arange(tilings)[:, None]
        self.offsets = tiling * (2 * np.arange(d) + 1) % tilings / tilings  # [tilings, d]
        self.mixers = self.random.integers(1, 2**62, d) | 1
        self.tiling_mix = self.random.integers(0, 2**62, tilings)
        self.memory, self.initial = memory, initial
        self.weights = self.random.uniform(0, initial / tilings, (memory, actions))
        self.alpha, self.gamma = step_size / tilings, discount
        self.decay, self.epsilon = discount * trace_decay, epsilon
        self.begin()

    def begin(self):
        """An episode begins: nothing is to blame yet."""
        self.marked = np.zeros(0, np.int64)  # weights with a trace, by their flat index
        self.trace = np.zeros(0)

    def features(self, state):
        """The active tile of each tiling: [tilings]."""
        x = np.clip((state - self.low) * self.scale, 0, self.top)
        cells = np.floor(x + self.offsets).astype(np.int64)
        return (((cells * self.mixers).sum(1) + self.tiling_mix) >> 20) % self.memory

    def choose(self, x):
        """An ε-greedy action for active tiles, and its value."""
        q = self.weights[x].sum(0)
        a = int(q.argmax())
        if self.random.random() < self.epsilon:
            a = int(self.random.integers(self.actions))
        return a, q[a]

    def learn(self, x, a, q, target):
        """Moves q̂(s, a) towards the target, and what led there after it."""
        new = x * self.actions + a
        keep = self.trace > 0.01 / self.decay
        keep &= ~np.isin(self.marked, new)  # replacing traces
        self.marked = np.concatenate([self.marked[keep], new])
        self.trace = np.concatenate([self.trace[keep] * self.decay, np.ones(len(new))])
        self.weights.ravel()[self.marked] += self.alpha * (target - q) * self.trace


def live(env, agent, minutes, seed=1):
    """Lives so long [simulated minutes]: the minute of every fall, and steps per second."""
    step_time = env.about["step_time"]
    fallen, begun, steps = [], time.perf_counter(), round(minutes * 60 / step_time)
    state, _ = env.reset(seed=seed)
    x = agent.features(state)
    a, q = agent.choose(x)
    for step in range(1, steps + 1):
        state, reward, terminated, truncated, info = env.step(a)
        if info["fall"]:
            fallen.append(step * step_time / 60)
        x2 = agent.features(state)
        a2, q2 = agent.choose(x2)
        agent.learn(x, a, q, reward if terminated else reward + agent.gamma * q2)
        if terminated or truncated:
            state, _ = env.reset()
            agent.begin()
            x2 = agent.features(state)
            a2, q2 = agent.choose(x2)
        x, a, q = x2, a2, agent.weights[x2, a2].sum()
    return np.array(fallen), steps / (time.perf_counter() - begun)


# %% [markdown]
# The pendulum: three state variables, five torques.

# %%
def tiles_of(env):
    """The library's usual number of tiles over the range of each state variable."""
    return np.array([(v["high"] - v["low"]) / v["span"] * v["resolution"]
                     for v in env.about["state"]])


def fallen_of(life):
    """The minute of every fall of one of Surefoot's lives."""
    rows = life.episodes()
    return np.repeat(rows["minutes"], rows["falls"])


results = {}
with surefoot.make("pendulum") as env:
    agent = Sarsa(env.ranges, int(env.action_space.n), tiles_of(env), memory=2**18)
    results["pendulum, yours"], speed = live(env, agent, MINUTES)
    print(f"yours: {speed:,.0f} steps/s")
with surefoot.Life(environment="pendulum", seed=1) as life:
    life.run(minutes=MINUTES)
    results["pendulum, Surefoot's"] = fallen_of(life)

# %% [markdown]
# LEO: ten state variables, 343 actions. The same agent; the resolutions are the library's.

# %%
with surefoot.make("leo") as env:
    agent = Sarsa(env.ranges, int(env.action_space.n), tiles_of(env), step_size=0.2,
                  discount=0.9962, trace_decay=0.8582, initial=0.01)
    results["LEO, yours"], speed = live(env, agent, LEO_MINUTES)
    print(f"yours: {speed:,.0f} steps/s")
with surefoot.Life(environment="leo", seed=1) as life:
    life.run(minutes=LEO_MINUTES)
    results["LEO, Surefoot's"] = fallen_of(life)

# %%
print(f"{'':22} {'first half':>10} {'second half':>12}   falls")
for name, fallen in results.items():
    half = (LEO_MINUTES if name.startswith("LEO") else MINUTES) / 2
    print(f"{name:22} {(fallen <= half).sum():10} {(fallen > half).sum():12}")

# %%
try:
    import matplotlib.pyplot as plt
except ImportError:
    print("Without Matplotlib there are no plots.")
else:
    figure, both = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
    for name, fallen in results.items():
        world, whose = name.split(", ")
        axes = both[int(world == "LEO")]
        axes.step(fallen, np.arange(1, len(fallen) + 1), where="post", label=whose)
        axes.set(xlabel="simulated minutes", ylabel="falls", title=world)
        axes.legend()
    figure.savefig(PICTURES / "own_agent.png", dpi=120)
    plt.close(figure)
