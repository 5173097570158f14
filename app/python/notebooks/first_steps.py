# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# First steps: a robot that falls, a learner that falls less, and what it has learned.
#
# Runs cell by cell in Jupyter or an editor, and as a whole: `python3 first_steps.py`.
# The environment variables MINUTES (of a life, simulated) and PICTURES (a folder) change it.

# %%
import os
from pathlib import Path

import numpy as np

import surefoot

MINUTES = float(os.environ.get("MINUTES", 9))
PICTURES = Path(os.environ.get("PICTURES", "."))

# %% [markdown]
# A world. Its interface is Gymnasium's; `about` tells what the numbers mean.

# %%
env = surefoot.make("pendulum", render_mode="rgb_array")
for variable in env.about["state"]:
    print(f"{variable['title']:12} {variable['low']:8.2f} … {variable['high']:.2f} "
          f"{variable['unit']}")
print("actions:", env.about["actions"])

state, info = env.reset(seed=1)
steps = falls = 0
while steps < 2000:
    state, reward, terminated, truncated, info = env.step(int(env.action_space.sample()))
    steps, falls = steps + 1, falls + info["fall"]
    if terminated or truncated:
        env.reset()
print(f"By chance it falls {falls} times in {steps} steps ({steps * 0.005:.0f} s).")
picture = env.render()
print("A picture:", picture.shape, picture.dtype)

# %% [markdown]
# Its learner. These are, bit for bit, the lives of `surefoot train`.

# %%
life = surefoot.Life(environment="pendulum", policy="epsilon-greedy", seed=1)
totals = life.run(minutes=MINUTES)
print(f"{totals.episodes} episodes, {totals.falls} falls in {totals.simulated_minutes:.2f} min; "
      f"hash {life.hash}")

episodes = life.episodes()  # a structured array, a row an episode
for name, part in (("first", episodes[:50]), ("last", episodes[-50:])):
    print(f"of the {name} {len(part)} episodes {(part['ending'] == 'fall').mean():.0%} are falls")

# %% [markdown]
# What it has learned: the value of the best action over the pole's angle and rate, the wheel still.

# %%
low, high = env.ranges
angle, rate = np.meshgrid(np.linspace(low[0], high[0], 101), np.linspace(low[1], high[1], 101))
states = np.stack([angle, rate, np.zeros_like(angle)], axis=-1)  # [101, 101, 3]
q = life.values(states)  # [101, 101, actions]
print("values:", q.shape, f"{q.max(-1).min():.1f} … {q.max(-1).max():.1f}")

# %%
file = PICTURES / "first_steps.safetensors"
file.unlink(missing_ok=True)
life.save(file)
with surefoot.load(file) as learned:
    assert np.allclose(learned.values(states), q)
    pi = learned.probabilities([0.1, 0.0, 0.0], "softmax", policy__temperature=1)
    print("softmax at 0.1 rad:", np.round(pi, 3))
print(f"`surefoot window --load {file}` shows it.")

# %%
try:
    import matplotlib.pyplot as plt
except ImportError:
    print("Without Matplotlib there are no plots.")
else:
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
    left.plot(episodes["minutes"], np.cumsum(episodes["falls"]))
    left.set(xlabel="simulated minutes", ylabel="falls")
    image = right.pcolormesh(angle, rate, q.max(-1), shading="auto")
    right.set(xlabel="angle [rad]", ylabel="rate [rad/s]", title="max Q")
    figure.colorbar(image, ax=right)
    figure.savefig(PICTURES / "first_steps.png", dpi=120)
    plt.close(figure)

env.close()
life.close()
