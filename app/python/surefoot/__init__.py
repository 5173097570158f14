# SPDX-License-Identifier: GPL-3.0-or-later
"""Surefoot: robots that learn by trial and error, and fall; learners that fall less.

    import surefoot

    # A robot that falls, for your own agent (the interface of Gymnasium, which need not be there)
    env = surefoot.make("pendulum")
    state, info = env.reset(seed=1)
    state, reward, terminated, truncated, info = env.step(env.action_space.sample())
    envs = surefoot.make_vec("pendulum", 64)          # many at once

    # Its learner: bit for bit the lives of the program `surefoot`
    life = surefoot.Life(environment="pendulum", policy="trl", seed=1)
    print(life.run(minutes=9).falls, life.hash)
    q = life.values([[0.1, 0, 0], [0.2, 0, 0]])       # float64 [2 states, 5 actions]
    life.save("q.safetensors"); q = surefoot.load("q.safetensors")

    # An experiment with honest intervals, and its results as arrays
    store = surefoot.experiment("quick", out="quick.sqlite", lives=20)
    for c in surefoot.statistics(store)["conditions"]:
        print(c["name"], c["falls"])                  # {"value", "low", "high"}: 95 %
    rows = surefoot.episodes(store)                   # structured; surefoot.frame(store): pandas

    # Your own world or policy under our learner (slow: Python is asked in every step)
    life = surefoot.Life(environment=my_world, policy=my_policy)

States, rewards and everything else are in the SI units that ``env.about`` tells. Everything that is
refused is a ``surefoot.Error`` whose sentence names the thing, the value and what is allowed. Other
threads of Python run while the library works; an object is used by one thread at a time. Ctrl-C
stops long calls, and nothing is lost.

Where Gymnasium is installed, ``import surefoot`` registers ``surefoot/Pendulum-v0``,
``Compass-v0``, ``Leo-v0``, ``Robot-v0`` (``robot="hopper.toml"``) and the small worlds, also for
``gymnasium.make_vec``.
"""

from __future__ import annotations

import ctypes as _ctypes
import json as _json
from typing import Any as _Any

from . import export
from ._environment import Environment, make
from ._errors import (ArgumentTypeError, BusyError, DivergedError, Error, FileError, InternalError,
                      MismatchError, MissingError, UnansweredError, UsageError)
from ._experiment import experiment
from ._kinds import IDS as _IDS
from ._library import check as _check, library as _c, version as __version__
from ._life import Life, Totals, resume
from ._q_function import QFunction, load
from ._results import conditions, episodes, frame, lives, statistics
from ._spaces import gymnasium as _gymnasium
from ._vector import VectorEnvironment, make_vec

__all__ = [
    "make", "make_vec", "Environment", "VectorEnvironment",
    "Life", "Totals", "resume", "load", "QFunction",
    "experiment", "statistics", "episodes", "lives", "conditions", "frame", "list_all", "export",
    "Error", "UsageError", "ArgumentTypeError", "FileError", "DivergedError", "MismatchError",
    "UnansweredError", "BusyError", "InternalError", "MissingError",
]


for _name in __all__:  # so that they are called surefoot.Life, and not by the file they stand in
    if _name != "export" and _name != "list_all":
        globals()[_name].__module__ = __name__


def list_all() -> dict[str, _Any]:
    """Everything that can be chosen by name, with every parameter, as `surefoot list --json`.

    {"environments", "robots", "features", "agents", "policies", "presets", "scenarios",
    "parameters": [{"name", "title", "unit", "range", "default", "applies", "help", "formula"}, …]}
    """
    text = _ctypes.c_char_p()
    _check(_c.surefoot_list(_ctypes.byref(text)))
    return _json.loads(text.value)


def _register() -> None:
    """Tells Gymnasium what there is."""
    for name, title in _IDS.items():
        _gymnasium.register(f"surefoot/{title}-v0", "surefoot._environment:Environment",
                            vector_entry_point="surefoot._vector:VectorEnvironment",
                            kwargs={"name": name})
    _gymnasium.register("surefoot/Robot-v0", "surefoot._environment:make_robot",
                        vector_entry_point="surefoot._vector:make_robot_vec")


if _gymnasium is not None:
    _register()
