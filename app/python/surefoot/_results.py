# SPDX-License-Identifier: GPL-3.0-or-later
"""What the store of an experiment holds, as dictionaries and arrays."""

from __future__ import annotations

import ctypes
import json
import os
from typing import Any, Mapping

import numpy as np

from ._descriptions import path_bytes, whole_number
from ._episodes import EPISODE, episodes_table
from ._errors import ArgumentTypeError, MissingError, UsageError
from ._library import Handle, address, check, library

Store = Any  # a file, or what experiment() gives


def statistics(store: Store) -> dict[str, Any]:
    """Falls, rewards, the end of learning … of every condition with their 95 % intervals.

    As ``surefoot statistics --json`` prints: ``statistics(store)["conditions"][0]["falls"]`` is
    {"value", "low", "high"}. `store`: its file, or what :func:`surefoot.experiment` gave.
    """
    with _Opened(store) as opened:
        return json.loads(opened.text(library.surefoot_store_statistics))


def conditions(store: Store) -> list[dict[str, Any]]:
    """The conditions: {"name", "reference", "text", "lives", "goal_reward", "step_time",
    "configuration"} each. Their numbers, from 0, are their places in this list."""
    with _Opened(store) as opened:
        return _about(opened)["conditions"]


def lives(store: Store) -> np.ndarray:
    """The lives: a structured array, a row each.

    ``condition`` and ``life`` (numbers from 0), ``q_function`` that it began with (−1: none),
    ``episodes``, ``steps``, ``falls``, ``states_outside``, ``diverged``, ``hash``, and a column for
    each measure of a life (NaN where it has none).
    """
    with _Opened(store) as opened:
        rows = _about(opened)["lives"]
    measures = sorted({key for row in rows for key in row["measures"]})
    counts = ("condition", "life", "episodes", "steps", "falls", "states_outside")
    table = np.zeros(len(rows), [(name, "i8") for name in counts] +
                     [("q_function", "i8"), ("diverged", "?"), ("hash", "U16")] +
                     [(key, "f8") for key in measures])
    for i, row in enumerate(rows):
        for name in counts:
            table[name][i] = row[name]
        table["q_function"][i] = -1 if row["q_function"] is None else row["q_function"]
        table["diverged"][i], table["hash"][i] = row["diverged"], row["hash"]
        for key in measures:
            value = row["measures"].get(key)
            table[key][i] = np.nan if value is None else value
    return table


def episodes(store: Store, condition: int | str | None = None, life: int | None = None
             ) -> np.ndarray:
    """The episodes: a structured array, a row each, with ``condition`` and ``life`` in front.

    The other columns are those of :meth:`surefoot.Life.episodes`, but for averages and measures,
    which a store does not keep for each episode.
    `condition`: its number or name, None: all. `life`: its number, None: all.
    """
    with _Opened(store) as opened:
        about = _about(opened)
        wanted = _condition_of(condition, about["conditions"])
        if life is not None:
            life = whole_number(life, "life")
        parts = []
        for row in about["lives"]:
            number = row["condition"]
            if wanted not in (None, number) or life not in (None, row["life"]):
                continue
            step_time = about["conditions"][number]["step_time"]
            table = episodes_table(_rows(opened, number, row["life"]), step_time, [], False)
            parts.append(_in_front(table, number, row["life"]))
        if not parts and (wanted is not None or life is not None):
            raise UsageError(f"the store has no life {life if life is not None else ''} of "
                             f"condition {condition!r}.")
    return np.concatenate(parts) if parts else _in_front(
        episodes_table(np.zeros(0, EPISODE), None, [], False), 0, 0)


def frame(source: Any, table: str = "episodes") -> Any:
    """A pandas DataFrame of a table of a store, with the conditions' names in it.

    `source`: a store, a life (its episodes), or an array of this package. `table`: "episodes" or
    "lives".
    """
    try:
        import pandas
    except ImportError:
        raise MissingError("frame() needs pandas (Debian: python3-pandas, elsewhere: pip install "
                           "pandas).") from None
    if isinstance(source, np.ndarray):
        return pandas.DataFrame(source)
    if hasattr(source, "episodes"):
        return pandas.DataFrame(source.episodes())
    tables = {"episodes": episodes, "lives": lives}
    if not isinstance(table, str) or table not in tables:
        raise UsageError(f'table = {table!r}; allowed are "episodes" and "lives".')
    data = pandas.DataFrame(tables[table](source))
    names = [c["name"] for c in conditions(source)]
    data.insert(1, "name", [names[c] for c in data["condition"]])
    return data


class _Opened:
    """``with _Opened(store) as handle``: open for the time of a call."""

    def __init__(self, store: Store) -> None:
        file = store.get("store") if isinstance(store, Mapping) else store
        if file is None or not isinstance(file, (str, bytes, os.PathLike)):
            raise ArgumentTypeError(f"store = {store!r} must be a file, or what experiment() gave.")
        self._handle = Handle("the store", library.surefoot_store_close).make(
            library.surefoot_store_open, path_bytes(file, "store"))

    def __enter__(self) -> Handle:
        return self._handle

    def __exit__(self, *_: Any) -> None:
        self._handle.close()


def _about(opened: Handle) -> dict[str, Any]:
    return json.loads(opened.text(library.surefoot_store_about))


def _rows(opened: Handle, condition: int, life: int) -> np.ndarray:
    there = ctypes.c_size_t()
    with opened as pointer:
        call = library.surefoot_store_episodes
        check(call(pointer, condition, life, 0, None, 0, ctypes.byref(there)))
        rows = np.zeros(there.value, EPISODE)
        check(call(pointer, condition, life, 0, address(rows), len(rows), ctypes.byref(there)))
    return rows


def _in_front(table: np.ndarray, condition: int, life: int) -> np.ndarray:
    wider = np.zeros(len(table), [("condition", "i4"), ("life", "i4"), *table.dtype.descr])
    wider["condition"], wider["life"] = condition, life
    for name in table.dtype.names:
        wider[name] = table[name]
    return wider


def _condition_of(condition: int | str | None, there: list[dict[str, Any]]) -> int | None:
    if condition is None:
        return None
    if isinstance(condition, str):
        names = [c["name"] for c in there]
        if condition not in names:
            raise UsageError(f"condition = {condition!r}; the store has "
                             f"{', '.join(map(repr, names))}.")
        return names.index(condition)
    return whole_number(condition, "condition", 0, max(0, len(there) - 1))
