# SPDX-License-Identifier: GPL-3.0-or-later
# %% [markdown]
# An experiment of one's own: a plan, many lives, and what they show, with 95 % intervals.
#
# LIVES, MINUTES (of a life, simulated) and PICTURES (a folder) change it.

# %%
import os
from pathlib import Path

import numpy as np

import surefoot

LIVES = int(os.environ.get("LIVES", 40))
MINUTES = float(os.environ.get("MINUTES", 6))
PICTURES = Path(os.environ.get("PICTURES", "."))

# %% [markdown]
# The plan, in TOML. Lists make conditions; `surefoot.list_all()` has all that can be set.

# %%
PLAN = f"""
title = "How often does it fall?"
lives = {LIVES}
reference = "ε-greedy"

[base]
environment = "pendulum"
minutes = {MINUTES}

[[condition]]
name = "ε-greedy"
policy = "epsilon-greedy"

[[condition]]
name = "Softmax, τ {{policy.temperature}}"
policy = "softmax"
set.policy.temperature = [0.5, 2]

[[condition]]
name = "TRL"
policy = "trl"
set.policy.threshold = 50
"""

file = PICTURES / "own_experiment.sqlite"
file.unlink(missing_ok=True)
store = surefoot.experiment(PLAN, out=file, progress=False)
print(f"{store['lives']} lives, content {store['content_hash']}")

# %%
found = surefoot.statistics(store)["conditions"]
names = [c["name"] for c in found]
for c in found:
    falls, reward = c["all_falls"], c["average_reward"]
    print(f"{c['name']:16} {falls['value']:6.1f} falls ({falls['low']:.1f} … {falls['high']:.1f}), "
          f"reward {reward['value']:6.1f} ({reward['low']:.1f} … {reward['high']:.1f})")

# %% [markdown]
# The episodes themselves, for one's own questions: falls up to each moment, life by life.

# %%
rows = surefoot.episodes(store)
moments = np.linspace(0, MINUTES, 61)


def falls_until(rows: np.ndarray) -> np.ndarray:
    """Falls of every life up to the moments: [lives, moments]."""
    curves = []
    for number in np.unique(rows["life"]):
        life = rows[rows["life"] == number]
        so_far = np.concatenate([[0], np.cumsum(life["falls"])])
        curves.append(so_far[np.searchsorted(life["minutes"], moments, side="right")])
    return np.array(curves)


curves = [falls_until(rows[rows["condition"] == i]) for i in range(len(names))]
for name, curve in zip(names, curves):
    print(f"{name:16} {curve[:, 30].mean():6.1f} falls after {moments[30]:.2g} min")

# %%
try:
    import matplotlib.pyplot as plt
except ImportError:
    print("Without Matplotlib there are no plots.")
else:
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
    value = np.array([[c["all_falls"][k] for k in ("value", "low", "high")] for c in found])
    left.errorbar(value[:, 0], range(len(names)), fmt="o", capsize=3,
                  xerr=[value[:, 0] - value[:, 1], value[:, 2] - value[:, 0]])
    left.set(yticks=range(len(names)), yticklabels=names, ylim=(len(names) - 0.5, -0.5),
             xlabel=f"falls in {MINUTES:g} min, mean of {LIVES} lives, 95 %")
    for name, curve in zip(names, curves):
        mean = curve.mean(0)
        error = 1.96 * curve.std(0, ddof=1) / np.sqrt(len(curve))
        right.plot(moments, mean, label=name)
        right.fill_between(moments, mean - error, mean + error, alpha=0.2)
    right.set(xlabel="simulated minutes", ylabel="falls")
    right.legend()
    figure.savefig(PICTURES / "own_experiment.png", dpi=120)
    plt.close(figure)
