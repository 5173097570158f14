# SPDX-License-Identifier: GPL-3.0-or-later
"""A world and a policy of the caller's own, as functions that the library calls."""

from __future__ import annotations

import ctypes
from typing import Any, Callable, Mapping

import numpy as np

from ._descriptions import json_text
from ._errors import ArgumentTypeError, UsageError
from ._library import Policy, ProbabilitiesCall, ResetCall, StepCall, World


class Own:
    """What the library calls back, kept alive, and the exception that came out of it."""

    def __init__(self) -> None:
        self.error: BaseException | None = None
        self.world: World | None = None
        self.policy: Policy | None = None

    def take_error(self) -> BaseException | None:
        """The exception of a callback since one looked last."""
        error, self.error = self.error, None
        return error

    def answer(self, call: Callable[[], None]) -> int:
        """0, or 1 and the exception is kept: none may go through the library."""
        try:
            call()
            return 0
        except BaseException as error:  # also SystemExit; it comes out of the call of the library
            self.error = error
            return 1


def doubles(place: int, count: int) -> Any:
    """The numbers at a place of the library."""
    return (ctypes.c_double * count).from_address(place)


# ---- Worlds ----------------------------------------------------------------------------------

def own_world(own: Own, environment: Any, task: Mapping[str, Any] | None) -> None:
    """Makes ``own.world`` of an object with reset() and step() as Gymnasium's environments."""
    for name in ("reset", "step"):
        if not callable(getattr(environment, name, None)):
            raise ArgumentTypeError(f"the environment = {environment!r} is no name and has no "
                                    f"{name}().")
    described = task_of(environment, task)
    variables = len(described["state"])
    terms = described.get("reward_terms")
    first = int(getattr(getattr(environment, "action_space", None), "start", 0))

    def reset(_: Any, seed: int, state: int) -> int:
        def call() -> None:
            told = environment.reset(seed=seed)
            where = told[0] if isinstance(told, tuple) and len(told) == 2 and \
                isinstance(told[1], Mapping) else told
            doubles(state, variables)[:] = _numbers(where, variables)
        return own.answer(call)

    def step(_: Any, action: int, state: int, parts: int, outcome: Any) -> int:
        def call() -> None:
            where, reward, terminated, truncated, info = environment.step(action + first)
            numbers = _numbers(where, variables)
            if terms:
                by_name = info["reward_terms"]
                doubles(parts, len(terms))[:] = [by_name[name] for name in terms]
            else:
                doubles(parts, 1)[0] = reward
            doubles(state, variables)[:] = numbers
            told = outcome.contents
            told.terminated = bool(terminated)
            told.truncated = bool(truncated) and not terminated
            told.fall, told.success = bool(info.get("fall")), bool(info.get("success"))
        return own.answer(call)

    own.world = World(json_text(described, "task"), None, ResetCall(reset), StepCall(step))


def _numbers(where: Any, variables: int) -> list[float]:
    numbers = np.asarray(where, dtype=float).reshape(-1).tolist()
    if len(numbers) != variables:
        raise UsageError(f"the environment gave {len(numbers)} numbers as its state; its task has "
                         f"{variables} state variables.")
    return numbers


def task_of(environment: Any, task: Mapping[str, Any] | None) -> dict[str, Any]:
    """The task of one's own world: what the caller says, the rest from its spaces."""
    given = task if task is not None else getattr(environment, "task", None)
    if given is not None and not isinstance(given, Mapping):
        raise ArgumentTypeError(f"task = {given!r} must be a dictionary.")
    described = dict(given or {})
    described.setdefault("title", type(environment).__name__)
    if "actions" not in described:
        count = getattr(getattr(environment, "action_space", None), "n", None)
        if count is None:
            raise UsageError("the environment has no Discrete action_space; say in its task what "
                             'its actions are: {"actions": [-1, 0, 1]}.')
        described["actions"] = list(range(int(count)))
    from_space = _state_of(getattr(environment, "observation_space", None))
    state = described.get("state") or from_space
    if not isinstance(state, (list, tuple)) or not all(isinstance(v, Mapping) for v in state):
        raise UsageError("the environment has no Box or Discrete observation_space; say in its "
                         'task what its state is: {"state": [{"key": "x", "low": -1, "high": 1}]}.')
    described["state"] = []
    for i, variable in enumerate(state):
        usual = from_space[i] if from_space and i < len(from_space) else {"key": f"x{i + 1}"}
        whole = {**usual, **variable}
        for bound in ("low", "high"):
            value = whole.get(bound)
            if value is None or not np.isfinite(value):
                raise UsageError(f"state variable {whole['key']} has {bound} = {value}; features "
                                 "need a finite range: say in the task which part matters.")
        described["state"].append(whole)
    return described


def _state_of(space: Any) -> list[dict[str, Any]] | None:
    """The state variables of a Box or Discrete."""
    if hasattr(space, "low") and hasattr(space, "high"):
        bounds = zip(np.ravel(space.low).tolist(), np.ravel(space.high).tolist())
        return [{"key": f"x{i + 1}", "low": low, "high": high}
                for i, (low, high) in enumerate(bounds)]
    if getattr(space, "n", None) is not None:
        first = int(getattr(space, "start", 0))
        return [{"key": "x1", "low": first, "high": first + int(space.n) - 1, "whole": True}]
    return None


# ---- Policies --------------------------------------------------------------------------------

def own_policy(own: Own, policy: Callable[[np.ndarray], Any]) -> None:
    """Makes ``own.policy`` of a function from the values of the actions to probabilities."""
    def probabilities(_: Any, q: int, actions: int, pi: int) -> int:
        def call() -> None:
            values = np.array(doubles(q, actions))
            told = np.asarray(policy(values), dtype=float)
            if told.shape != (actions,):
                raise UsageError(f"the policy gave the shape {told.shape}; it must be "
                                 f"({actions},), a probability for each action.")
            if not (np.isfinite(told).all() and (told >= 0).all() and told.sum() > 0):
                raise UsageError(f"the policy gave {told.tolist()}; probabilities must not be "
                                 "negative, and their sum must be positive.")
            doubles(pi, actions)[:] = told.tolist()
        return own.answer(call)

    own.policy = Policy(None, ProbabilitiesCall(probabilities))
