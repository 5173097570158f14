# SPDX-License-Identifier: GPL-3.0-or-later
"""Many worlds that take a step in one call, with Gymnasium's interface of such."""

from __future__ import annotations

import ctypes
import json
import os
import secrets
from typing import Any, Mapping, Sequence

import numpy as np

from ._descriptions import json_text, whole_number
from ._errors import ArgumentTypeError, UsageError
from ._kinds import environment_description, observation_space_of
from ._library import Batch, Handle, address, check, library
from ._spaces import AutoresetMode, Discrete, VectorEnv, batch_space

#: A mode, what a caller may write for it, and its number in the library.
_MODES = {AutoresetMode.DISABLED: 0, AutoresetMode.NEXT_STEP: 1, AutoresetMode.SAME_STEP: 2}


class VectorEnvironment(VectorEnv):
    """`num_envs` worlds of one kind; made by :func:`surefoot.make_vec`, or by Gymnasium.

    World i is bit for bit the one that :func:`surefoot.make` makes and that is reset with seed + i.
    The dictionary of ``step`` has arrays [num_envs]: "fall", "success", and in "reward_terms" one
    for each term; "_fall" and so on are true where a world took a step that counts.
    """

    def __init__(self, name: str | os.PathLike, num_envs: int = 1, *,
                 autoreset: str | AutoresetMode = "next_step", preset: str | None = None,
                 scenario: str | None = None, parameters: Mapping[str, Any] | None = None,
                 programs: bool = False, render_mode: None = None, **keywords: Any) -> None:
        self.num_envs = whole_number(num_envs, "num_envs", 1, 100_000)
        self.autoreset_mode = _mode_of(autoreset)
        if render_mode is not None:
            raise UsageError("many worlds at once draw nothing: render_mode must be None.")
        description = environment_description(name, preset, scenario, parameters, programs,
                                              keywords)
        self._handle = Handle("the vector environment", library.surefoot_worlds_close).make(
            library.surefoot_worlds_make, json_text(description, "the environment"),
            self.num_envs, _MODES[self.autoreset_mode])
        about = self.about
        self.metadata = {"autoreset_mode": self.autoreset_mode, "render_modes": []}
        self.single_observation_space = observation_space_of(about)
        self.single_action_space = Discrete(len(about["actions"]))
        self.observation_space = batch_space(self.single_observation_space, self.num_envs)
        self.action_space = batch_space(self.single_action_space, self.num_envs)
        self._seeded = False
        self._over = np.zeros(self.num_envs, bool)

        n, variables = self.num_envs, len(about["state"])
        self._terms = tuple(about["reward_terms"])
        self._states = np.zeros((n, variables))
        self._last_states = np.zeros((n, variables))
        self._rewards = np.zeros(n)
        self._flags = np.zeros((4, n), np.uint8)
        self._reward_terms = np.zeros((n, len(self._terms)))
        self._batch = Batch(address(self._states), address(self._rewards),
                            *(address(flags) for flags in self._flags),
                            address(self._reward_terms), address(self._last_states))
        self._batch_ref = ctypes.byref(self._batch)

    def reset(self, *, seed: int | Sequence[int | None] | None = None,
              options: Mapping[str, Any] | None = None) -> tuple[np.ndarray, dict[str, Any]]:
        """Begins an episode in every world; gives the states, float64 [num_envs, state variables].

        `seed`: world i begins with seed + i; a list has one for each world, all given. None: the
        random numbers go on, the first time from a seed drawn by chance.
        `options`: {"reset_mask": bool [num_envs]} resets only these worlds.
        """
        which = self._mask_of(options)
        with self._handle as pointer:
            if seed is None and not self._seeded:
                seed = secrets.randbits(62)
            seeds = None if seed is None else self._seeds_of(seed)
            check(library.surefoot_worlds_reset(
                pointer, None if seeds is None else address(seeds),
                None if which is None else address(which), address(self._states)))
            if seeds is not None:
                super().reset(seed=int(seeds[0]))
                self._seeded = True
            self._over[slice(None) if which is None else which.astype(bool)] = False
            return self._states.copy(), {}

    def step(self, actions: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray,
                                                 dict[str, Any]]:
        """One decision in every world.

        `actions`: whole numbers [num_envs]. Gives states [num_envs, state variables], rewards,
        terminated, truncated [num_envs] and a dictionary. A world whose episode is over begins its
        next one in the next step (its action is not used, its reward is 0); with
        ``autoreset="same_step"`` at once, and "final_obs" and "final_info" have how it ended; with
        ``autoreset="disabled"`` when ``reset`` is called with its mask.
        """
        actions = self._actions_of(actions)
        with self._handle as pointer:
            check(library.surefoot_worlds_step(pointer, address(actions), self._batch_ref))
            flags = self._flags.view(bool).copy()
            states, rewards = self._states.copy(), self._rewards.copy()
            terms = self._reward_terms.T.copy()
            terminated, truncated, falls, successes = flags
            over = terminated | truncated
            if self.autoreset_mode is AutoresetMode.NEXT_STEP:
                infos = self._infos(falls, successes, terms, ~self._over)
            elif self.autoreset_mode is AutoresetMode.SAME_STEP and over.any():
                infos = self._infos(falls, successes, terms, ~over)
                last = np.full(self.num_envs, None, dtype=object)
                for i in np.flatnonzero(over):
                    last[i] = self._last_states[i].copy()
                infos.update(final_obs=last, _final_obs=over,
                             final_info=self._infos(falls, successes, terms, over),
                             _final_info=over)
            else:
                infos = self._infos(falls, successes, terms, np.ones(self.num_envs, bool))
            self._over = over
            return states, rewards, terminated, truncated, infos

    def _infos(self, falls: np.ndarray, successes: np.ndarray, terms: np.ndarray,
               where: np.ndarray) -> dict[str, Any]:
        by_name: dict[str, Any] = {}
        for name, values in zip(self._terms, terms):
            by_name[name], by_name["_" + name] = values * where, where
        return {"fall": falls & where, "_fall": where, "success": successes & where,
                "_success": where, "reward_terms": by_name, "_reward_terms": where}

    @property
    def about(self) -> dict[str, Any]:
        """Everything about the world, as :attr:`surefoot.Environment.about`."""
        return json.loads(self._handle.text(library.surefoot_worlds_about))

    def render(self) -> None:
        """Many worlds at once draw nothing."""

    def close_extras(self, **_: Any) -> None:
        """Gives everything back."""
        if hasattr(self, "_handle"):
            self._handle.close()

    def __enter__(self) -> "VectorEnvironment":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def __reduce__(self) -> Any:
        raise ArgumentTypeError("environments cannot be copied or pickled; make others.")

    def __repr__(self) -> str:
        return f"<surefoot vector environment of {self.num_envs}>"

    __str__ = __repr__

    def _actions_of(self, actions: Any) -> np.ndarray:
        try:
            array = np.asarray(actions)
            if array.dtype.kind not in "iu":
                raise TypeError
        except (TypeError, ValueError):
            raise ArgumentTypeError("actions must be an array of whole numbers.") from None
        if array.shape != (self.num_envs,):
            raise UsageError(f"actions has the shape {array.shape}; it must be "
                             f"({self.num_envs},).")
        most = int(self.single_action_space.n) - 1
        if array.min() < 0 or array.max() > most:
            raise UsageError(f"actions has {array.min()} … {array.max()}; allowed is 0 … {most}.")
        return np.ascontiguousarray(array, dtype=np.int64)

    def _seeds_of(self, seed: Any) -> np.ndarray:
        if isinstance(seed, (list, tuple, np.ndarray)):
            if len(seed) != self.num_envs:
                raise UsageError(f"seed has {len(seed)} numbers for {self.num_envs} worlds.")
            seeds = [whole_number(s, "seed") for s in seed]
        else:
            first = whole_number(seed, "seed", 0, 2**64 - self.num_envs)
            seeds = [first + i for i in range(self.num_envs)]
        return np.array(seeds, dtype=np.uint64)

    def _mask_of(self, options: Any) -> np.ndarray | None:
        if options is None:
            return None
        if not isinstance(options, Mapping):
            raise ArgumentTypeError(f"options = {options!r} must be a dictionary.")
        unknown = set(options) - {"reset_mask"}
        if unknown:
            raise UsageError(f"options has {sorted(map(str, unknown))}; allowed is "
                             '"reset_mask".')
        mask = options.get("reset_mask")
        if mask is None:
            return None
        if not isinstance(mask, np.ndarray) or mask.dtype != np.bool_:
            raise ArgumentTypeError('options["reset_mask"] must be an array of bool.')
        if mask.shape != (self.num_envs,) or not mask.any():
            raise UsageError(f'options["reset_mask"] has the shape {mask.shape} and '
                             f"{int(mask.sum())} worlds; it must be ({self.num_envs},), and true "
                             "for at least one.")
        return mask.astype(np.uint8)


def make_vec(name: str | os.PathLike, num_envs: int, *,
             autoreset: str | AutoresetMode = "next_step", preset: str | None = None,
             scenario: str | None = None, parameters: Mapping[str, Any] | None = None,
             programs: bool = False, **keywords: Any) -> VectorEnvironment:
    """Makes 1 to 100,000 worlds that take a step in one call, several times as fast as one by one.

    `autoreset`: "next_step" (as Gymnasium does), "same_step" or "disabled", or Gymnasium's
    AutoresetMode. The other arguments are those of :func:`surefoot.make`.

        envs = surefoot.make_vec("pendulum", 64)
        states, infos = envs.reset(seed=1)                  # [64, 3]
        states, rewards, terminated, truncated, infos = envs.step(envs.action_space.sample())
    """
    return VectorEnvironment(name, num_envs, autoreset=autoreset, preset=preset,
                             scenario=scenario, parameters=parameters, programs=programs,
                             **keywords)


def make_robot_vec(robot: str | os.PathLike, **keywords: Any) -> VectorEnvironment:
    """As :func:`make_vec`, of the file of a robot."""
    return VectorEnvironment(robot, **keywords)


def _mode_of(autoreset: Any) -> AutoresetMode:
    if isinstance(autoreset, AutoresetMode):
        return autoreset
    for mode in AutoresetMode:
        if isinstance(autoreset, str) and autoreset in (mode.name.lower(), mode.value):
            return mode
    raise UsageError(f'autoreset = {autoreset!r}; allowed are "next_step", "same_step" and '
                     '"disabled".')
