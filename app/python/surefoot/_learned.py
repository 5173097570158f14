# SPDX-License-Identifier: GPL-3.0-or-later
"""What lives and Q-functions are asked alike, of many states at once."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._descriptions import states_array
from ._errors import UsageError
from ._library import Handle, address, check, library

LAYERS = {"sum": 0, "positive": 1, "negative": 2, "risk": 3}


class Learned:
    """States are arrays [..., state variables]; the last axis of an answer has the actions."""

    _kind: str  # how the library's calls begin: "life" or "q_function"
    _handle: Handle
    _variables: int
    _actions: int

    def values(self, states: Any, layer: str = "sum") -> np.ndarray:
        """Q of every action in the states: [..., state variables] → float64 [..., actions].

        `layer`: "sum" is Q; "positive" and "negative" are Q+ and Q− of learners that keep them;
        "risk" is the risk of a fall, where it is learned.
        """
        if not isinstance(layer, str) or layer not in LAYERS:
            raise UsageError(f"layer = {layer!r}; allowed are {', '.join(LAYERS)}.")
        return self._ask("values", states, self._actions, LAYERS[layer])

    def probabilities(self, states: Any) -> np.ndarray:
        """π of every action in the states: [..., state variables] → float64 [..., actions]."""
        return self._ask("probabilities", states, self._actions)

    def visits(self, states: Any) -> np.ndarray:
        """How often the features of the states were visited, on average: → float64 [...]."""
        return self._ask("visits", states, None)

    def _ask(self, what: str, states: Any, columns: int | None, *first: int) -> np.ndarray:
        rows, shape = states_array(states, self._variables)
        shape = shape if columns is None else (*shape, columns)
        answer = np.zeros(shape)
        with self._handle as pointer:
            self._check(getattr(library, f"surefoot_{self._kind}_{what}")(
                pointer, *first, address(rows), len(rows), address(answer), answer.size))
        return answer

    def _check(self, status: int) -> None:
        check(status)
