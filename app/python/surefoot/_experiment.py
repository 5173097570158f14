# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a plan of many lives into a store."""

from __future__ import annotations

import ctypes
import json
import os
import sys
import time
from typing import Any, Callable, Mapping

from ._descriptions import flag, json_text, parameters_of, path_bytes, whole_number, without_none
from ._errors import ArgumentTypeError
from ._interrupts import Interruptible
from ._library import Handle, ProgressCall, check, library, text_of


def experiment(plan: str | os.PathLike, out: str | os.PathLike = "results.sqlite", *,
               lives: int | None = None, seed: int | None = None, jobs: int | None = None,
               resume: bool = False, parameters: Mapping[str, Any] | None = None,
               programs: bool = False,
               progress: bool | Callable[[dict[str, Any]], Any] = True,
               **keywords: Any) -> dict[str, Any]:
    """Runs a plan, all lives of each condition, into a store, as ``surefoot experiment`` does.

    `plan`: the name of a plan that comes with the program, a file, or the text of one in TOML.
    `out`: the store to write, which must not exist yet, but for `resume`: then what is missing in
    it is done.
    `lives`: of each condition; `seed`: the master seed; both in place of the plan's. `jobs`:
    threads, all cores by default.
    `parameters` and `keywords` hold in every condition: ``policy__epsilon=0.1``.
    `progress`: True prints a line to standard error; or a function of {"share": 0 … 1, "lives",
    "of", "falls", "steps"}, called about four times a second; an exception in it stops the
    experiment and comes out.

    Gives {"store", "lives", "of", "complete", "content_hash", "found"}: for
    :func:`surefoot.statistics`, :func:`surefoot.episodes` … as their store. Ctrl-C stops it: the
    lives that are done are kept, KeyboardInterrupt is raised, and ``resume=True`` does the rest.
    """
    if isinstance(plan, str) and "\n" in plan:
        what = text_of(plan, "plan")
    else:
        what = path_bytes(plan, "plan")
    path_bytes(out, "out")
    options = without_none(
        out=os.fspath(out), resume=flag(resume, "resume"), programs=flag(programs, "programs"),
        lives=None if lives is None else whole_number(lives, "lives", 1),
        seed=None if seed is None else whole_number(seed, "seed"),
        jobs=None if jobs is None else whole_number(jobs, "jobs", 1, 10_000),
        parameters=parameters_of(parameters, keywords))
    tell = _Line() if progress is True else None if progress is False else progress
    if tell is not None and not callable(tell):
        raise ArgumentTypeError(f"progress = {progress!r} must be True, False or a function.")

    failed: list[BaseException] = []
    visit = Handle("the experiment", lambda _: 0)  # so that the interpreter's end waits for it
    visit.pointer = 1
    with Interruptible() as ask, visit:
        def on_progress(_: Any, now: Any) -> int:
            try:
                if tell is not None:
                    p = now.contents
                    tell({"share": p.share, "lives": p.lives, "of": p.of, "falls": p.falls,
                          "steps": p.steps})
            except BaseException as error:
                failed.append(error)
            return 1 if failed or ask.stop else 0

        result = ctypes.c_char_p()
        status = library.surefoot_experiment(
            what, json_text(options, "the experiment"), ProgressCall(on_progress), None,
            ctypes.byref(result))
        if isinstance(tell, _Line):
            tell.end()
        if failed:
            raise failed[0]
        if status:
            ask.raise_if_asked()
        check(status)
        return json.loads(result.value)


class _Line:
    """Progress as a line that is written over; where no terminal is, only every tenth of it."""

    def __init__(self) -> None:
        self._begun, self._written, self._next = time.monotonic(), False, 0.1

    def __call__(self, now: dict[str, Any]) -> None:
        seconds, share = time.monotonic() - self._begun, now["share"]
        if not sys.stderr.isatty():
            if share < self._next:
                return
            self._next = share + 0.1
        left = "" if share <= 0.01 else f", about {seconds * (1 / share - 1):,.0f} s left"
        print(f"\r{100 * share:.0f} %: {now['lives']:,} of {now['of']:,} lives, "
              f"{now['falls']:,} falls{left}   ", end="", file=sys.stderr, flush=True)
        self._written = True

    def end(self) -> None:
        """Nothing is written over the last state."""
        if self._written:
            print(file=sys.stderr)
