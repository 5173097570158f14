# SPDX-License-Identifier: GPL-3.0-or-later
"""A learner in its world, from its first step on."""

from __future__ import annotations

import ctypes
import dataclasses
import json
import os
import sys
import time
from typing import Any, Callable, Mapping

import numpy as np

from ._descriptions import finite_number, flag, json_text, numbers_array, parameters_of, \
    path_bytes, value_text, whole_number, without_none
from ._environment import Environment
from ._episodes import EPISODE, episodes_table
from ._errors import ArgumentTypeError, UsageError
from ._interrupts import Interruptible
from ._learned import Learned
from ._library import CTotals, Extent, Handle, address, check, library, text_of
from ._own import Own, own_policy, own_world

_SLICE = 0.2  # s between two looks at Ctrl-C


@dataclasses.dataclass(frozen=True)
class Totals:
    """What a life has come to."""

    steps: int  #: decisions
    episodes: int  #: those that are over
    falls: int
    successes: int
    simulated_minutes: float | None  #: None: the task has no clock
    average_reward: float  #: of the last 80 episodes; 0 before the first
    exploring: float  #: share of the steps whose action was not the best by Q
    states_outside: int  #: states outside the ranges that the features cover


class Life(Learned):
    """A learner in its world: bit for bit what ``surefoot train`` lives, with the same ``hash``.

    `configuration`: a dictionary; every entry can be given as a keyword instead:

    - ``environment``: "pendulum" (the default), "compass", "leo", "cliff" …, the file of a robot,
      or **a world of one's own**: an object with Gymnasium's ``reset(seed=)`` and ``step(action)``
      and Discrete actions. Its state variables and their ranges are those of its
      ``observation_space``, or of `task`, or of its attribute ``task``: {"state": [{"key", "low",
      "high", and if wanted "title", "unit", "resolution" (tiles), "period", "whole"}],
      "actions": [numbers or names], "reward_terms": [names], "step_time": s, "can_fall": True}.
      ``info["fall"]``, ``info["success"]`` and, where the task names them, ``info["reward_terms"]``
      tell what a step was.
    - ``preset``, ``scenario``, ``agent`` ("sarsa", "sarsa-2q" …), ``features``: names.
    - ``policy``: "epsilon-greedy", "softmax", "trl" …, or **a policy of one's own**: a function
      from the values of the actions, float64 [actions], to their probabilities.
    - ``seed`` (0 … 2^64 − 1), ``life`` (which life of this seed, from 0).
    - ``load``: the file of a Q-function to begin with; ``programs``: a robot's program may start.
    - ``parameters``: {"policy.epsilon": 0.1}. As keywords two underscores stand for the dot:
      ``policy__epsilon=0.1``. ``surefoot.list_all()["parameters"]`` has all.

        life = surefoot.Life(environment="pendulum", policy="trl", seed=1, policy__threshold=50)
        print(life.run(minutes=9).falls)

    A world or policy of one's own is slow: Python is asked in every step; ``run(progress=True)``
    prints how fast it is. An exception in it comes out of ``run`` as it is; the life stays usable,
    and the step that did not happen is tried again by the next ``run``.

    Used by one thread at a time.
    """

    _kind = "life"

    def __init__(self, configuration: Mapping[str, Any] | None = None, *,
                 environment: Any = None, preset: str | None = None, scenario: str | None = None,
                 agent: str | None = None, features: str | None = None,
                 policy: str | Callable[[np.ndarray], Any] | None = None,
                 seed: int | None = None, life: int | None = None,
                 load: str | os.PathLike | None = None,
                 parameters: Mapping[str, Any] | None = None,
                 task: Mapping[str, Any] | None = None, programs: bool | None = None,
                 **keywords: Any) -> None:
        if configuration is not None and not isinstance(configuration, Mapping):
            raise ArgumentTypeError(f"configuration = {configuration!r} must be a dictionary.")
        description = dict(configuration or {})
        given = without_none(
            environment=environment, preset=preset, scenario=scenario, agent=agent,
            features=features, policy=policy, load=load,
            programs=None if programs is None else flag(programs, "programs"),
            seed=None if seed is None else whole_number(seed, "seed"),
            life=None if life is None else whole_number(life, "life"),
            parameters=parameters_of(parameters, keywords))
        if "parameters" in given and isinstance(description.get("parameters"), Mapping):
            given["parameters"] = {**description["parameters"], **given["parameters"]}
        description.update(given)
        self._own = Own()
        self._take_own(description, task)
        own = self._own
        self._handle = Handle("the life", library.surefoot_life_close)
        self._handle.make(library.surefoot_life_make,
                          json_text(description, "the configuration"),
                          ctypes.byref(own.world) if own.world else None,
                          ctypes.byref(own.policy) if own.policy else None)
        about = self.task
        self._variables, self._actions = len(about["state"]), len(about["actions"])
        self._step_time = about["step_time"]
        self._measures = [m["key"] for m in about["measures"]]

    def _take_own(self, description: dict[str, Any], task: Mapping[str, Any] | None) -> None:
        world = description.get("environment")
        if isinstance(world, Environment):
            raise UsageError("the environment is one of the library's: give its name to the life, "
                             "which makes one of its own.")
        if world is None or isinstance(world, (str, os.PathLike)):
            if task is not None:
                raise UsageError("task is for a world of one's own; no such environment is given.")
        else:
            own_world(self._own, world, task)
            del description["environment"]
        if callable(description.get("policy")):
            own_policy(self._own, description.pop("policy"))

    def run(self, minutes: float | None = None, episodes: int | None = None,
            steps: int | None = None, *, progress: bool = False) -> Totals:
        """Lives on for so much more, until the first of the limits; gives what it has come to.

        `minutes`: simulated, for tasks with a clock. `episodes`: ends of episodes. `steps`:
        decisions. `progress`: prints steps per second to standard error, once a second.
        Ctrl-C stops it between two steps; the life can be asked, saved and run on.
        """
        extent = self._extent(minutes, episodes, steps)
        reached = ctypes.c_int32()
        begun = shown = time.monotonic()
        with Interruptible() as ask, self._handle as pointer:
            before = self._totals(pointer)
            while not reached.value:
                self._check(library.surefoot_life_run(pointer, ctypes.byref(extent),
                                                      ctypes.byref(reached)))
                if progress and (reached.value or time.monotonic() > shown + 1):
                    shown = time.monotonic()
                    _print_progress(before, self._totals(pointer), shown - begun, reached.value)
                ask.raise_if_asked()
            return self._totals(pointer)

    def _extent(self, minutes: Any, episodes: Any, steps: Any) -> Extent:
        if minutes is None and episodes is None and steps is None:
            raise UsageError("how far? Give minutes, episodes or steps.")
        if minutes is not None and self._step_time is None:
            raise UsageError("minutes: this task has no clock; give steps or episodes instead.")
        totals, extent = self.totals, Extent(patience=_SLICE)
        if steps is not None:
            extent.steps = totals.steps + whole_number(steps, "steps", 1, 2**53)
        if episodes is not None:
            extent.episodes = totals.episodes + whole_number(episodes, "episodes", 1, 2**53)
        if minutes is not None:
            more = finite_number(minutes, "minutes")
            if more <= 0:
                raise UsageError(f"minutes = {more} must be above 0.")
            extent.minutes = totals.simulated_minutes + more
        return extent

    @property
    def totals(self) -> Totals:
        """What the life has come to so far."""
        with self._handle as pointer:
            return self._totals(pointer)

    def _totals(self, pointer: int) -> Totals:
        t = CTotals()
        check(library.surefoot_life_totals(pointer, ctypes.byref(t)))
        clock = self._step_time is not None
        return Totals(t.steps, t.episodes, t.falls, t.successes,
                      t.simulated_seconds / 60 if clock else None, t.average_reward, t.exploring,
                      t.states_outside)

    @property
    def hash(self) -> str:
        """Every row of the log and every weight in 16 hex digits, as ``surefoot train`` prints."""
        number = ctypes.c_uint64()
        with self._handle as pointer:
            check(library.surefoot_life_hash(pointer, ctypes.byref(number)))
        return f"{number.value:016x}"

    @property
    def about(self) -> dict[str, Any]:
        """What ``surefoot train --json`` prints of such a life: configuration and results."""
        return json.loads(self._handle.text(library.surefoot_life_about))

    @property
    def task(self) -> dict[str, Any]:
        """Everything about its world, as :attr:`surefoot.Environment.about`."""
        return json.loads(self._handle.text(library.surefoot_life_task))

    def episodes(self) -> np.ndarray:
        """The episodes that are over: a structured array, a row each.

        ``episode`` (from 1), ``transitions`` (its steps), ``steps`` and ``minutes`` (of the life
        up to its end; NaN without a clock), ``reward`` (undiscounted), ``average_reward`` (of the
        last 80), ``falls``, ``ending`` ("end", "success", "fall", "truncated"), and the task's
        measures.
        """
        there = ctypes.c_size_t()
        with self._handle as pointer:
            call = library.surefoot_life_episodes
            check(call(pointer, 0, None, 0, ctypes.byref(there)))
            rows = np.zeros(there.value, EPISODE)
            check(call(pointer, 0, address(rows), len(rows), ctypes.byref(there)))
        return episodes_table(rows, self._step_time, self._measures)

    def set(self, key: str, value: Any) -> None:
        """Sets a parameter, ``life.set("policy.epsilon", 0.01)``.

        When it takes effect (now, with the next episode), ``surefoot.list_all()`` says.
        """
        self._tell("set", _text(key, "key"), _text(value_text(value, str(key)), str(key)))

    def follow(self, policy: str) -> None:
        """Follows another policy from now on, by its name."""
        self._tell("follow", _text(policy, "policy"))

    def push(self, impulse: float) -> None:
        """Pushes the body to the right by an impulse [N s]."""
        self._tell("push", finite_number(impulse, "impulse"))

    def place(self, state: Any) -> None:
        """Begins an episode in a state, [state variables], each within its range."""
        numbers = numbers_array(state, "state").reshape(-1)
        self._tell("place", address(numbers), numbers.size)

    def save(self, file: str | os.PathLike) -> None:
        """Writes what was learned to a file that must not exist yet (:func:`surefoot.load`)."""
        self._tell("save", path_bytes(file))

    def checkpoint(self, file: str | os.PathLike) -> None:
        """Writes the whole life, to go on from bit for bit (:func:`surefoot.resume`)."""
        self._tell("checkpoint", path_bytes(file))

    def close(self) -> None:
        """Gives everything back. A second time does nothing."""
        self._handle.close()

    def _tell(self, what: str, *arguments: Any) -> None:
        with self._handle as pointer:
            self._check(getattr(library, "surefoot_life_" + what)(pointer, *arguments))

    def _check(self, status: int) -> None:
        error = self._own.take_error()
        if error is not None:
            raise error
        check(status)

    def __enter__(self) -> "Life":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def __reduce__(self) -> Any:
        raise ArgumentTypeError("a life cannot be copied or pickled; checkpoint() writes it whole.")

    def __repr__(self) -> str:
        if self._handle.pointer is None:
            return "<surefoot life, closed>"
        t = self.totals
        return f"<surefoot life: {t.steps} steps, {t.episodes} episodes, {t.falls} falls>"


def resume(file: str | os.PathLike, *, environment: Any = None,
           policy: Callable[[np.ndarray], Any] | None = None,
           task: Mapping[str, Any] | None = None, programs: bool | None = None) -> Life:
    """The life of a checkpoint, which goes on as if nothing had happened.

    A world or a policy of one's own must be given again.
    """
    path_bytes(file)
    return Life({"resume": os.fspath(file)}, environment=environment, policy=policy, task=task,
                programs=programs)


def _text(value: Any, what: str) -> bytes:
    if not isinstance(value, str):
        raise ArgumentTypeError(f"{what} = {value!r} must be a text.")
    return text_of(value, what)


def _print_progress(before: Totals, now: Totals, seconds: float, last: int) -> None:
    rate = (now.steps - before.steps) / max(seconds, 1e-9)
    clock = "" if now.simulated_minutes is None else f"{now.simulated_minutes:.1f} min, "
    print(f"\r{clock}{now.episodes:,} episodes, {now.falls:,} falls, {now.steps:,} steps, "
          f"{rate:,.0f} steps/s  ", end="\n" if last else "", file=sys.stderr, flush=True)
