# SPDX-License-Identifier: GPL-3.0-or-later
"""Which environments there are, and what one and many of a kind have in common."""

from __future__ import annotations

import copy
import os
from typing import Any, Mapping

import numpy as np

from ._descriptions import flag, parameters_of, without_none
from ._errors import ArgumentTypeError
from ._spaces import Box, gymnasium

#: Gymnasium's names of the environments that come with the library.
IDS = {"cliff": "Cliff", "grid-world": "GridWorld", "chain": "Chain", "random-walk": "RandomWalk",
       "mountain-car": "MountainCar", "pendulum": "Pendulum", "compass": "Compass", "leo": "Leo"}


def environment_description(name: Any, preset: str | None, scenario: str | None,
                            parameters: Mapping[str, Any] | None, programs: bool,
                            keywords: Mapping[str, Any]) -> dict[str, Any]:
    """The description of an environment that the library reads."""
    if not isinstance(name, (str, os.PathLike)):
        raise ArgumentTypeError(f"the environment = {name!r} must be a name such as \"pendulum\", "
                                "or the file of a robot.")
    return without_none(environment=os.fspath(name), preset=preset, scenario=scenario,
                        parameters=parameters_of(parameters, keywords, "environment."),
                        programs=flag(programs, "programs"))


def observation_space_of(about: Mapping[str, Any]) -> Box:
    """The states that an environment can come to, float64 [state variables].

    It is unbounded: a robot that falls leaves the range that matters (``Environment.ranges``), and
    a row of places ends beside its last one; the state is told all the same.
    """
    return Box(-np.inf, np.inf, (len(about["state"]),), np.float64)


def spec_of(name: str, keywords: Mapping[str, Any]) -> Any:
    """Gymnasium's description of an environment that was not made by Gymnasium."""
    if gymnasium is None:
        return None
    spec = copy.deepcopy(gymnasium.spec(f"surefoot/{IDS.get(name, 'Robot')}-v0"))  # that is of all
    spec.kwargs = {**({"name": name} if name in IDS else {"robot": name}), **keywords}
    return spec
