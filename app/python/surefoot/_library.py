# SPDX-License-Identifier: GPL-3.0-or-later
"""The C library: found, checked, and every call of surefoot.h declared once.

ctypes lets other threads of Python run while a call is inside the library.
"""

from __future__ import annotations

import atexit
import ctypes
import os
import threading
import time
import weakref
from ctypes import POINTER, c_char_p, c_double, c_int, c_int32, c_int64, c_size_t, c_uint, \
    c_uint64, c_uint8, c_void_p
from pathlib import Path
from typing import Any, Callable, List

from ._errors import BusyError, MissingError, UsageError, error_of

API = 1
MEASURES = 4


class Outcome(ctypes.Structure):
    """surefoot_outcome"""

    _fields_ = [("reward", c_double), ("terminated", c_int32), ("truncated", c_int32),
                ("fall", c_int32), ("success", c_int32)]


class Batch(ctypes.Structure):
    """surefoot_batch"""

    _fields_ = [(name, c_void_p) for name in (
        "states", "rewards", "terminated", "truncated", "falls", "successes", "reward_terms",
        "last_states")]


ResetCall = ctypes.CFUNCTYPE(c_int, c_void_p, c_uint64, c_void_p)
StepCall = ctypes.CFUNCTYPE(c_int, c_void_p, c_int64, c_void_p, c_void_p, POINTER(Outcome))
ProbabilitiesCall = ctypes.CFUNCTYPE(c_int, c_void_p, c_void_p, c_size_t, c_void_p)


class World(ctypes.Structure):
    """surefoot_world"""

    _fields_ = [("task", c_char_p), ("user", c_void_p), ("reset", ResetCall), ("step", StepCall)]


class Policy(ctypes.Structure):
    """surefoot_policy"""

    _fields_ = [("user", c_void_p), ("probabilities", ProbabilitiesCall)]


class Extent(ctypes.Structure):
    """surefoot_extent"""

    _fields_ = [("steps", c_int64), ("episodes", c_int64), ("minutes", c_double),
                ("patience", c_double)]


class CTotals(ctypes.Structure):
    """surefoot_totals"""

    _fields_ = [("steps", c_int64), ("episodes", c_int64), ("falls", c_int64),
                ("successes", c_int64), ("simulated_seconds", c_double),
                ("average_reward", c_double), ("exploring", c_double),
                ("states_outside", c_int64)]


class CProgress(ctypes.Structure):
    """surefoot_progress"""

    _fields_ = [("share", c_double), ("lives", c_int32), ("of", c_int32), ("falls", c_int64),
                ("steps", c_int64)]


ProgressCall = ctypes.CFUNCTYPE(c_int, c_void_p, POINTER(CProgress))

_HANDLE, _OUT, _TEXT, _SIZE = c_void_p, POINTER(c_void_p), POINTER(c_char_p), c_size_t
_ARRAY = c_void_p  # the address of an array that the caller has checked
_CALLS = {
    "list": [_TEXT],
    "environment_make": [c_char_p, _OUT],
    "environment_close": [_HANDLE],
    "environment_about": [_HANDLE, _TEXT],
    "environment_set": [_HANDLE, c_char_p, c_char_p],
    "environment_reset": [_HANDLE, POINTER(c_uint64), _ARRAY],
    "environment_step": [_HANDLE, c_int64, POINTER(Outcome), _ARRAY, _ARRAY],
    "environment_state": [_HANDLE, _ARRAY, _SIZE],
    "environment_measures": [_HANDLE, _ARRAY, _SIZE],
    "environment_signals": [_HANDLE, _ARRAY, _SIZE],
    "environment_place": [_HANDLE, _ARRAY, _SIZE],
    "environment_push": [_HANDLE, c_double],
    "environment_hand_made": [_HANDLE, POINTER(c_int64)],
    "environment_draw": [_HANDLE, _TEXT],
    "environment_render": [_HANDLE, c_int32, c_int32, _ARRAY, _SIZE],
    "worlds_make": [c_char_p, _SIZE, c_int, _OUT],
    "worlds_close": [_HANDLE],
    "worlds_about": [_HANDLE, _TEXT],
    "worlds_reset": [_HANDLE, _ARRAY, _ARRAY, _ARRAY],
    "worlds_step": [_HANDLE, _ARRAY, POINTER(Batch)],
    "life_make": [c_char_p, POINTER(World), POINTER(Policy), _OUT],
    "life_close": [_HANDLE],
    "life_run": [_HANDLE, POINTER(Extent), POINTER(c_int32)],
    "life_totals": [_HANDLE, POINTER(CTotals)],
    "life_hash": [_HANDLE, POINTER(c_uint64)],
    "life_about": [_HANDLE, _TEXT],
    "life_task": [_HANDLE, _TEXT],
    "life_episodes": [_HANDLE, _SIZE, _ARRAY, _SIZE, POINTER(_SIZE)],
    "life_values": [_HANDLE, c_int, _ARRAY, _SIZE, _ARRAY, _SIZE],
    "life_probabilities": [_HANDLE, _ARRAY, _SIZE, _ARRAY, _SIZE],
    "life_visits": [_HANDLE, _ARRAY, _SIZE, _ARRAY, _SIZE],
    "life_set": [_HANDLE, c_char_p, c_char_p],
    "life_follow": [_HANDLE, c_char_p],
    "life_push": [_HANDLE, c_double],
    "life_place": [_HANDLE, _ARRAY, _SIZE],
    "life_save": [_HANDLE, c_char_p],
    "life_checkpoint": [_HANDLE, c_char_p],
    "q_function_open": [c_char_p, _OUT],
    "q_function_close": [_HANDLE],
    "q_function_about": [_HANDLE, _TEXT],
    "q_function_values": [_HANDLE, c_int, _ARRAY, _SIZE, _ARRAY, _SIZE],
    "q_function_follow": [_HANDLE, c_char_p, c_char_p],
    "q_function_probabilities": [_HANDLE, _ARRAY, _SIZE, _ARRAY, _SIZE],
    "q_function_visits": [_HANDLE, _ARRAY, _SIZE, _ARRAY, _SIZE],
    "experiment": [c_char_p, c_char_p, ProgressCall, c_void_p, _TEXT],
    "store_open": [c_char_p, _OUT],
    "store_close": [_HANDLE],
    "store_about": [_HANDLE, _TEXT],
    "store_statistics": [_HANDLE, _TEXT],
    "store_episodes": [_HANDLE, c_int32, c_int32, _SIZE, _ARRAY, _SIZE, POINTER(_SIZE)],
}


def _candidates() -> List[str]:
    """Where it may be: as the caller says; beside this file or built from its sources; anywhere."""
    named = os.environ.get("SUREFOOT_LIBRARY")
    if named:
        return [named]
    here = Path(__file__).resolve().parent
    folders = [here, *(p / "build" / "release" for p in here.parents[2:3])]
    found = [str(file) for folder in folders for file in sorted(folder.glob("libsurefoot.so*"))]
    return [*found, "libsurefoot.so.1"]


def _load() -> ctypes.CDLL:
    reasons = []
    for name in _candidates():
        try:
            library = ctypes.CDLL(name)
            library.surefoot_api.restype = c_uint
            there = library.surefoot_api()
            if there != API:
                reasons.append(f"{name} has the calls of number {there}, this package needs {API}")
                continue
            library.surefoot_version.restype = c_char_p
            library.surefoot_last_error.restype = c_char_p
            for call, arguments in _CALLS.items():
                function = getattr(library, "surefoot_" + call)
                function.restype, function.argtypes = c_int, arguments
            return library
        except (OSError, AttributeError) as error:
            reasons.append(f"{name}: {error}")
    sources = Path(__file__).resolve().parents[2] / "library" / "surefoot.h"
    build = " `cmake --build build/release --target surefoot_library` builds it from its sources." \
        if sources.is_file() else ""
    raise MissingError("the C library of Surefoot was not found: " + "; ".join(reasons) +
                       ". The environment variable SUREFOOT_LIBRARY can name it." + build)


library = _load()
version: str = library.surefoot_version().decode()


def check(status: int) -> None:
    """Raises what a status means."""
    if status:
        raise error_of(status, library.surefoot_last_error().decode("utf-8", "replace"))


def address(array: Any) -> int:
    """Where the numbers of a NumPy array lie."""
    return array.ctypes.data


def text_of(value: str, what: str) -> bytes:
    """A text for the library, in UTF-8."""
    if "\0" in value:
        raise UsageError(f"{what} has a character that no text can hold (number 0): {value!r}.")
    try:
        return value.encode("utf-8")
    except UnicodeEncodeError:
        raise UsageError(f"{what} is no text that UTF-8 can hold: {value!r}.") from None


# ---- Handles ---------------------------------------------------------------------------------

_all_handles: "weakref.WeakSet[Handle]" = weakref.WeakSet()
_ending = False


def ending() -> bool:
    """Whether the interpreter is about to end: what runs in other threads comes back then."""
    return _ending


class Handle:
    """A thing of the library, used by one thread at a time and closed once.

    ``with handle:`` is the way in; ``handle.pointer`` is None once it was closed.
    """

    __slots__ = ("pointer", "what", "_close", "lock", "__weakref__")

    def __init__(self, what: str, close: Callable[[int], int]) -> None:
        self.pointer = None
        self.what = what
        self._close = close
        self.lock = threading.Lock()
        if _ending:
            raise BusyError(f"{what} cannot be made: the interpreter is ending.")
        _all_handles.add(self)

    def make(self, call: Callable[..., int], *arguments: Any) -> "Handle":
        """Fills the handle by a call whose last argument is where to put it."""
        out = c_void_p()
        check(call(*arguments, ctypes.byref(out)))
        self.pointer = out.value
        return self

    def enter(self) -> int:
        """Takes the handle for this thread; ``leave`` gives it back."""
        if not self.lock.acquire(False):
            if _ending and threading.current_thread() is not threading.main_thread():
                raise SystemExit  # without a word: the thread would be stopped anyway
            raise BusyError(f"{self.what} is busy: another thread, or a call further out, "
                            "is inside; use one thread at a time.")
        if self.pointer is None:
            self.lock.release()
            raise UsageError(f"{self.what} is closed.")
        return self.pointer

    def __enter__(self) -> int:
        return self.enter()

    def __exit__(self, *_: Any) -> None:
        self.lock.release()

    def text(self, call: Callable[..., int], *arguments: Any) -> str:
        """A text that the library hands out."""
        out = c_char_p()
        with self as pointer:
            check(call(pointer, *arguments, ctypes.byref(out)))
            return out.value.decode("utf-8", "replace")

    def close(self) -> None:
        """Gives it back; a second time does nothing."""
        if self.pointer is None or _ending:
            return
        with self as pointer:
            self.pointer = None
            check(self._close(pointer))

    def __del__(self) -> None:
        # Nobody else has it any more, so no thread is inside.
        if getattr(self, "pointer", None) is not None and not _ending:
            self._close(self.pointer)


@atexit.register
def _end() -> None:
    """Lets nobody into the library any more, and waits for those who are inside.

    Daemon threads are stopped by the interpreter wherever they are, which must not be inside C++.
    Lives and experiments look at ``ending()`` several times a second.
    """
    global _ending
    _ending = True
    until = time.monotonic() + 30
    for handle in list(_all_handles):
        handle.lock.acquire(timeout=max(0.0, until - time.monotonic()))
