# SPDX-License-Identifier: GPL-3.0-or-later
"""From what a caller of Python writes to the texts and arrays that the library reads."""

from __future__ import annotations

import json
import math
import numbers
import operator
import os
from typing import Any, Dict, Mapping, Optional, Tuple

import numpy as np

from ._errors import ArgumentTypeError, UsageError

MOST = 2**64 - 1


def json_text(value: Any, what: str) -> bytes:
    """A description as JSON. NumPy's numbers are numbers; NaN and infinity are none."""
    def plain(other: Any) -> Any:
        if isinstance(other, np.generic):
            return other.item()
        if isinstance(other, os.PathLike):
            return os.fspath(other)
        if isinstance(other, np.ndarray):
            return other.tolist()
        if isinstance(other, Mapping):
            return dict(other)
        raise ArgumentTypeError(f"{what} has a value of type {type(other).__name__}: {other!r}; "
                                "allowed are numbers, texts, lists and dictionaries of them.")

    try:
        return json.dumps(value, allow_nan=False, default=plain).encode()
    except ArgumentTypeError:
        raise
    except TypeError as error:
        raise ArgumentTypeError(f"{what}: {error}.") from None
    except (ValueError, RecursionError) as error:
        raise UsageError(f"{what}: {error}; numbers must be finite, nothing may hold itself."
                         ) from None


def parameters_of(given: Optional[Mapping[str, Any]], keywords: Mapping[str, Any],
                  prefix: str = "") -> Dict[str, Any]:
    """All parameters by their whole keys.

    Two underscores in a keyword stand for the dot of a key: ``policy__epsilon=0.1`` is
    {"policy.epsilon": 0.1}. Keywords without them get `prefix`.
    """
    if given is not None and not isinstance(given, Mapping):
        raise ArgumentTypeError(f"parameters is a {type(given).__name__}; it must be a dictionary "
                                'such as {"environment.damping": 0.1}.')
    parameters = dict(given or {})
    for keyword, value in keywords.items():
        key = keyword.replace("__", ".") if "__" in keyword else prefix + keyword
        if key in parameters:
            raise UsageError(f"{key} is given twice.")
        parameters[key] = value
    return parameters


def without_none(**entries: Any) -> Dict[str, Any]:
    """What was given, of a description's entries."""
    return {key: value for key, value in entries.items()
            if value is not None and not (isinstance(value, dict) and not value)}


def whole_number(value: Any, what: str, low: int = 0, high: int = MOST) -> int:
    """A whole number in a range; True and 1.0 are none."""
    try:
        if isinstance(value, (bool, np.bool_)):
            raise TypeError
        number = operator.index(value)
    except TypeError:
        raise ArgumentTypeError(f"{what} = {value!r} must be a whole number.") from None
    if not low <= number <= high:
        raise UsageError(f"{what} = {number}; allowed is {low} … {high}.")
    return number


def finite_number(value: Any, what: str) -> float:
    """A number that is not NaN and not infinite."""
    try:
        if isinstance(value, str):
            raise TypeError
        number = float(value)
    except (TypeError, ValueError):
        raise ArgumentTypeError(f"{what} = {value!r} must be a number.") from None
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise UsageError(f"{what} = {number} must be finite.")
    return number


def flag(value: Any, what: str) -> bool | None:
    """True, or None for False."""
    if not isinstance(value, (bool, np.bool_)):
        raise ArgumentTypeError(f"{what} = {value!r} must be True or False.")
    return True if value else None


def value_text(value: Any, what: str) -> str:
    """The value of a parameter as the text that means exactly it."""
    if isinstance(value, str):
        return value
    if isinstance(value, (bool, np.bool_)):
        return "on" if value else "off"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    return repr(finite_number(value, what))


def states_array(states: Any, variables: int, what: str = "states"
                 ) -> Tuple[np.ndarray, Tuple[int, ...]]:
    """States [..., variables] as float64 [n, variables] in one piece, and the shape before."""
    array = numbers_array(states, what)
    if array.ndim == 0 or array.shape[-1] != variables:
        raise UsageError(f"{what} has the shape {array.shape}; the last axis must have the "
                         f"{variables} state variables.")
    return np.ascontiguousarray(array.reshape(-1, variables)), array.shape[:-1]


def numbers_array(values: Any, what: str) -> np.ndarray:
    """Finite numbers as float64 in one piece."""
    try:
        array = np.asarray(values)
        if array.dtype.kind not in "biuf":
            raise TypeError
        array = np.ascontiguousarray(array, dtype=np.float64)
    except (TypeError, ValueError):
        raise ArgumentTypeError(f"{what} must be an array of numbers.") from None
    if not np.isfinite(array).all():
        raise UsageError(f"{what} has a number that is not finite.")
    return array if np.ndim(values) else array.reshape(())


def path_bytes(file: Any, what: str = "file") -> bytes:
    """A file's name as the system has it."""
    try:
        name = os.fsencode(file)
    except (TypeError, UnicodeEncodeError):
        raise ArgumentTypeError(f"{what} = {file!r} must be the name of a file.") from None
    if not name or b"\0" in name:
        raise UsageError(f"{what} = {file!r} is no name of a file.")
    return name
