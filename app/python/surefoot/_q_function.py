# SPDX-License-Identifier: GPL-3.0-or-later
"""A Q-function from a file: what a life has learned."""

from __future__ import annotations

import json
import os
from typing import Any, Mapping

import numpy as np

from ._descriptions import json_text, parameters_of, path_bytes
from ._errors import ArgumentTypeError
from ._learned import Learned
from ._library import Handle, check, library, text_of


class QFunction(Learned):
    """What a life has learned, opened by :func:`surefoot.load`; it learns nothing more.

    Used by one thread at a time.
    """

    _kind = "q_function"

    def __init__(self, file: str | os.PathLike) -> None:
        self._handle = Handle("the Q-function", library.surefoot_q_function_close).make(
            library.surefoot_q_function_open, path_bytes(file))
        task = self.about["task"]
        self._variables, self._actions = len(task["state"]), len(task["actions"])
        self._followed: Any = (None, None)

    @property
    def about(self) -> dict[str, Any]:
        """Where it comes from: "configuration", "origin" (a sentence), "content" (a hash of the
        values), "layers", and "task" as :attr:`surefoot.Environment.about`."""
        return json.loads(self._handle.text(library.surefoot_q_function_about))

    def probabilities(self, states: Any, policy: str | None = None,
                      parameters: Mapping[str, Any] | None = None, **keywords: Any) -> np.ndarray:
        """π of every action in the states: [..., state variables] → float64 [..., actions].

        `policy`: its name; None: that of the file. Its parameters are the file's where none are
        given: ``q.probabilities(states, "softmax", policy__temperature=0.5)``.
        """
        if policy is not None and not isinstance(policy, str):
            raise ArgumentTypeError(f"policy = {policy!r} must be the name of a policy.")
        changed = parameters_of(parameters, keywords)
        wanted = (None if policy is None else text_of(policy, "policy"),
                  json_text(changed, "parameters") if changed else None)
        if wanted != self._followed:
            with self._handle as pointer:
                check(library.surefoot_q_function_follow(pointer, *wanted))
                self._followed = wanted
        return super().probabilities(states)

    def close(self) -> None:
        """Gives everything back. A second time does nothing."""
        self._handle.close()

    def __enter__(self) -> "QFunction":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def __reduce__(self) -> Any:
        raise ArgumentTypeError("a Q-function cannot be copied or pickled; load its file again.")

    def __repr__(self) -> str:
        return f"<surefoot Q-function{', closed' if self._handle.pointer is None else ''}>"


def load(file: str | os.PathLike) -> QFunction:
    """Opens what a life has learned: a file of :meth:`Life.save`, `surefoot train --save`, or of
    the window."""
    return QFunction(file)
