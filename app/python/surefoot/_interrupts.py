# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C while the library works: noted, carried out at the next good moment."""

from __future__ import annotations

import signal
import threading
from typing import Any

from ._library import ending


class Interruptible:
    """``with Interruptible() as ask:`` Ctrl-C does not break into what is done inside; ``ask.stop``
    tells of it. A second Ctrl-C does break in, for a world of one's own that hangs.

    Only in the main thread, and only if Ctrl-C is handled as Python does by itself.
    """

    def __init__(self) -> None:
        self._asked = False
        self._before: Any = None

    @property
    def stop(self) -> bool:
        """Whether the work should end as soon as it can."""
        return self._asked or ending()

    def raise_if_asked(self) -> None:
        """KeyboardInterrupt, if Ctrl-C was pressed; a thread ends silently with the interpreter."""
        if self._asked:
            self._asked = False
            raise KeyboardInterrupt
        if ending():
            raise SystemExit

    def __enter__(self) -> "Interruptible":
        if threading.current_thread() is threading.main_thread() and \
                signal.getsignal(signal.SIGINT) is signal.default_int_handler:
            self._before = signal.signal(signal.SIGINT, self._ask)
        return self

    def __exit__(self, *_: Any) -> None:
        if self._before is not None:
            signal.signal(signal.SIGINT, self._before)
            self._before = None
        if self._asked:
            raise KeyboardInterrupt

    def _ask(self, number: int, frame: Any) -> None:
        if self._asked:
            signal.default_int_handler(number, frame)
        self._asked = True
