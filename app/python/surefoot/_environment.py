# SPDX-License-Identifier: GPL-3.0-or-later
"""A world in which robots fall, with the interface of Gymnasium."""

from __future__ import annotations

import ctypes
import json
import operator
import os
import secrets
from typing import Any, Mapping

import numpy as np

from ._descriptions import finite_number, json_text, numbers_array, value_text, whole_number, \
    without_none
from ._errors import ArgumentTypeError, UsageError
from ._kinds import environment_description, observation_space_of, spec_of
from ._library import Handle, Outcome, address, check, library, text_of
from ._spaces import Discrete, Env

class Environment(Env):
    """A world with a task; made by :func:`surefoot.make`, or by Gymnasium.

    ``observation_space`` is a Box of float64 [state variables], in the units of ``about["state"]``.
    It is unbounded, because a state may lie outside the range that matters for learning; that one
    is ``ranges``.
    ``action_space`` is Discrete; ``about["actions"]`` has what each action does.

    ``step`` tells in its dictionary: ``fall`` and ``success`` (whether this step was one) and
    ``reward_terms`` (the parts whose sum the reward is, by name). ``terminated`` and ``truncated``
    are never both true.

    Used by one thread at a time. The random numbers of the world are the library's: the same seed
    gives the same episodes, bit for bit, here, in :func:`surefoot.make_vec` and on other machines.
    """

    metadata = {"render_modes": ["human", "rgb_array"], "render_fps": 30}

    def __init__(self, name: str | os.PathLike, *, preset: str | None = None,
                 scenario: str | None = None, render_mode: str | None = None,
                 render_size: tuple[int, int] = (640, 400),
                 parameters: Mapping[str, Any] | None = None, programs: bool = False,
                 **keywords: Any) -> None:
        description = environment_description(name, preset, scenario, parameters, programs,
                                              keywords)
        if not (render_mode is None or
                isinstance(render_mode, str) and render_mode in ("human", "rgb_array")):
            raise UsageError(f'render_mode = {render_mode!r}; allowed are None, "human" and '
                             '"rgb_array".')
        self._size = _size_of(render_size)
        self._screen = None
        if render_mode == "human":
            from ._screen import Screen
            self._screen = Screen()
        self.render_mode = render_mode
        self._handle = Handle("the environment", library.surefoot_environment_close).make(
            library.surefoot_environment_make, json_text(description, "the environment"))
        about = self.about
        self._ranges = np.array([[v["low"] for v in about["state"]],
                                 [v["high"] for v in about["state"]]])
        self.observation_space = observation_space_of(about)
        self.action_space = Discrete(len(about["actions"]))
        self.metadata = dict(type(self).metadata)
        if about["step_time"]:
            self.metadata["render_fps"] = min(30, max(1, round(1 / about["step_time"])))
        self._step_time = about["step_time"] or 1.0
        self.spec = spec_of(description["environment"], without_none(
            preset=preset, scenario=scenario, render_mode=render_mode,
            parameters=description.get("parameters"), programs=description.get("programs")))
        self._seeded = False

        # What a step writes into, made once.
        self._actions = len(about["actions"])
        self._terms = tuple(about["reward_terms"])
        self._state = np.zeros(len(about["state"]))
        self._rewards = (ctypes.c_double * len(self._terms))()
        self._outcome = Outcome()
        self._step = library.surefoot_environment_step
        self._where = (ctypes.byref(self._outcome), address(self._state),
                       ctypes.addressof(self._rewards))
        self._signal_keys = [s["key"] for s in about["signals"]]
        self._measure_keys = [m["key"] for m in about["measures"]]

    def reset(self, *, seed: int | None = None, options: Mapping[str, Any] | None = None
              ) -> tuple[np.ndarray, dict[str, Any]]:
        """Begins an episode; gives the state it begins in, and an empty dictionary.

        `seed`: 0 … 2^64 − 1, the world's random numbers begin anew from it. None: they go on; the
        first time they begin with a seed drawn by chance (``np_random_seed`` has it).
        `options`: {"state": [a number for each state variable]} begins in this state instead of a
        random one; each must lie within its range.
        """
        start = _start_of(options)
        seed = None if seed is None else whole_number(seed, "seed")
        with self._handle as pointer:
            if seed is None and not self._seeded:
                seed = secrets.randbits(63)
            if seed is not None or start is None:
                number = None if seed is None else ctypes.c_uint64(seed)
                check(library.surefoot_environment_reset(pointer, number, self._where[1]))
            if seed is not None:
                super().reset(seed=seed)
                self._seeded = True
            if start is not None:
                check(library.surefoot_environment_place(pointer, address(start), start.size))
                check(library.surefoot_environment_state(pointer, self._where[1],
                                                         self._state.size))
            observation = self._state.copy()
        if self._screen:
            self._screen.begin()
            self.render()
        return observation, {}

    def step(self, action: int) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """One decision: state, reward, terminated, truncated, {"fall", "success", "reward_terms"}.

        `action`: 0 … number of actions − 1. An episode must have begun and not be over.
        """
        if type(action) is not int:
            action = _action_of(action)
        if not 0 <= action < self._actions:
            raise UsageError(f"action = {action}; allowed is 0 … {self._actions - 1}.")
        handle, outcome = self._handle, self._outcome
        pointer = handle.enter()
        try:
            status = self._step(pointer, action, *self._where)
            if status:
                check(status)
            result = (self._state.copy(), outcome.reward, outcome.terminated != 0,
                      outcome.truncated != 0,
                      {"fall": outcome.fall != 0, "success": outcome.success != 0,
                       "reward_terms": dict(zip(self._terms, self._rewards))})
        finally:
            handle.lock.release()
        if self._screen and self._screen.due(self._step_time, result[2] or result[3]):
            self.render()
        return result

    def render(self) -> np.ndarray | None:
        """The picture of now: uint8 [height, width, 3] if ``render_mode`` is "rgb_array".

        With "human" a window of Matplotlib shows it, at most as fast as the robot is; nothing has
        to be called for that. Without a ``render_mode``: None.
        """
        if self.render_mode is None:
            return None
        width, height = self._size
        picture = np.zeros((height, width, 3), np.uint8)
        with self._handle as pointer:
            check(library.surefoot_environment_render(pointer, width, height, address(picture),
                                                      picture.size))
        if self._screen is None:
            return picture
        self._screen.show(picture)
        return None

    def close(self) -> None:
        """Gives everything back. A second time does nothing."""
        screen = getattr(self, "_screen", None)
        if screen is not None:
            screen.close()
        self._handle.close()

    @property
    def about(self) -> dict[str, Any]:
        """Everything about the world: parameters, state variables, actions, reward terms, signals.

        ``about["state"]`` has key, title, symbol, unit, low and high of every state variable,
        ``about["actions"]`` the physical values of every action, ``about["step_time"]`` seconds.
        """
        return json.loads(self._handle.text(library.surefoot_environment_about))

    @property
    def ranges(self) -> np.ndarray:
        """The range of every state variable that features cover: float64 [2, state variables]."""
        return self._ranges.copy()

    @property
    def state(self) -> np.ndarray:
        """The state now, float64 [state variables]."""
        return self._values(library.surefoot_environment_state, self._state.size)

    def signals(self) -> dict[str, float]:
        """What moves besides the state, by key: torques, contacts (0 or 1), energy … in SI."""
        values = self._values(library.surefoot_environment_signals, len(self._signal_keys))
        return dict(zip(self._signal_keys, values.tolist()))

    def measures(self) -> dict[str, float]:
        """The task's measures of the episode so far, by key, e.g. the distance walked [m]."""
        values = self._values(library.surefoot_environment_measures, len(self._measure_keys))
        return dict(zip(self._measure_keys, values.tolist()))

    def push(self, impulse: float) -> None:
        """Pushes the body to the right by an impulse [N s], between two steps."""
        impulse = finite_number(impulse, "impulse")
        with self._handle as pointer:
            check(library.surefoot_environment_push(pointer, impulse))

    def hand_made(self) -> int:
        """The action that the task's hand-made controller would take now."""
        action = ctypes.c_int64()
        with self._handle as pointer:
            check(library.surefoot_environment_hand_made(pointer, ctypes.byref(action)))
        return action.value

    def draw(self) -> dict[str, Any]:
        """The picture of now as shapes in metres: lines, polygons, discs, arrows, labels."""
        return json.loads(self._handle.text(library.surefoot_environment_draw))

    def set(self, key: str, value: Any) -> None:
        """Sets a parameter ("environment.damping", or "damping"); it holds from the next reset."""
        if not isinstance(key, str):
            raise ArgumentTypeError(f"key = {key!r} must be the name of a parameter.")
        key = key if "." in key else "environment." + key
        text = text_of(value_text(value, key), key)
        with self._handle as pointer:
            check(library.surefoot_environment_set(pointer, text_of(key, "key"), text))

    def _values(self, call: Any, count: int) -> np.ndarray:
        values = np.zeros(count)
        with self._handle as pointer:
            check(call(pointer, address(values), count))
        return values

    def __reduce__(self) -> Any:
        raise ArgumentTypeError("an environment cannot be copied or pickled; make another one.")

    def __repr__(self) -> str:
        if self._handle.pointer is None:
            return "<surefoot environment, closed>"
        about = self.about
        words = [str(about[k]) for k in ("environment", "preset", "scenario") if about.get(k)]
        return f"<surefoot environment: {', '.join(words)}>"

    __str__ = __repr__


def make(name: str | os.PathLike, *, preset: str | None = None, scenario: str | None = None,
         render_mode: str | None = None, render_size: tuple[int, int] = (640, 400),
         parameters: Mapping[str, Any] | None = None, programs: bool = False,
         **keywords: Any) -> Environment:
    """Makes an environment with the interface of Gymnasium (which need not be installed).

    `name`: "pendulum", "compass", "leo", "cliff", … (``surefoot.list_all()["environments"]``), or
    the file of a robot, "hopper.toml".
    `preset`, `scenario`: their names; None: the first.
    `render_mode`: None, "rgb_array" or "human" (with Matplotlib). `render_size`: width and height
    of pictures in pixels, 16 … 4096.
    `keywords`: parameters of the environment, ``damping=0.16``; or `parameters`, by whole keys:
    {"environment.damping": 0.16}. They hold from the first reset on.
    `programs`: a robot that is moved by a program of its own may start it.

        env = surefoot.make("pendulum", scenario="2", damping=0.1)
        state, info = env.reset(seed=1)
        state, reward, terminated, truncated, info = env.step(env.action_space.sample())
    """
    return Environment(name, preset=preset, scenario=scenario, render_mode=render_mode,
                       render_size=render_size, parameters=parameters, programs=programs,
                       **keywords)


def make_robot(robot: str | os.PathLike, **keywords: Any) -> Environment:
    """Makes a robot from its file: gymnasium.make("surefoot/Robot-v0", robot="hopper.toml")."""
    return Environment(robot, **keywords)


def _size_of(size: Any) -> tuple[int, int]:
    try:
        width, height = size
    except (TypeError, ValueError):
        raise ArgumentTypeError(f"render_size = {size!r} must be a width and a height in pixels."
                                ) from None
    return (whole_number(width, "the width of pictures", 16, 4096),
            whole_number(height, "the height of pictures", 16, 4096))


def _action_of(action: Any) -> int:
    try:
        if isinstance(action, (bool, np.bool_)):
            raise TypeError
        return operator.index(action)
    except TypeError:
        raise ArgumentTypeError(f"action = {action!r} must be a whole number.") from None


def _start_of(options: Mapping[str, Any] | None) -> np.ndarray | None:
    if options is None:
        return None
    if not isinstance(options, Mapping):
        raise ArgumentTypeError(f"options = {options!r} must be a dictionary.")
    unknown = set(options) - {"state"}
    if unknown:
        raise UsageError(f"options has {sorted(map(str, unknown))}; allowed is \"state\".")
    if options.get("state") is None:
        return None
    return numbers_array(options["state"], 'options["state"]').reshape(-1)
