# SPDX-License-Identifier: GPL-3.0-or-later
"""What goes wrong, by kind. The sentences name the thing, the value and what is allowed."""

from __future__ import annotations


class Error(Exception):
    """Anything that Surefoot refuses or cannot do.

    Every exception of this package is one; most are also one of Python's own, so that
    ``except ValueError`` works as one expects. ``status`` is the number of the C library,
    the exit code of the program.
    """

    status = 8


class UsageError(Error, ValueError):
    """An argument is wrong: a name, a value, a shape, the order of calls."""

    status = 2


class ArgumentTypeError(Error, TypeError):
    """An argument is of a wrong type."""

    status = 2


class FileError(Error, OSError):
    """A file cannot be read or written, or is damaged."""

    status = 3


class DivergedError(Error, ArithmeticError):
    """The learned values left every sensible range; the life is over, and can still be asked."""

    status = 4


class MismatchError(Error, ValueError):
    """A file of another version, or of another task."""

    status = 5


class UnansweredError(Error, RuntimeError):
    """A world in another process, or of one's own, did not answer; it can be tried again."""

    status = 6


class BusyError(Error, RuntimeError):
    """Another thread, or the caller itself further out, is inside this object."""

    status = 7


class InternalError(Error, RuntimeError):
    """No memory, or a fault of the library."""

    status = 8


class MissingError(Error, ImportError):
    """The C library, or an optional Python package that this call needs, is not there."""


_BY_STATUS = {kind.status: kind for kind in (UsageError, FileError, DivergedError, MismatchError,
                                             UnansweredError, BusyError, InternalError)}


def error_of(status: int, sentence: str) -> BaseException:
    """The exception of a status of the library."""
    if status == 130:
        return KeyboardInterrupt(sentence)
    return _BY_STATUS.get(status, InternalError)(sentence or "the library gives no reason.")
