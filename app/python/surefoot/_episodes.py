# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of episodes: the library's, and the table that a caller gets."""

from __future__ import annotations

from typing import Sequence

import numpy as np

from ._library import MEASURES

#: surefoot_episode
EPISODE = np.dtype([("episode", "i8"), ("transitions", "i8"), ("steps", "i8"), ("reward", "f8"),
                    ("average_reward", "f8"), ("measures", "f8", MEASURES), ("falls", "i4"),
                    ("ending", "i4")], align=True)
ENDINGS = np.array(["end", "success", "fall", "truncated"])


def episodes_table(rows: np.ndarray, step_time: float | None, measures: Sequence[str],
                   with_average: bool = True) -> np.ndarray:
    """The table of these rows, with minutes, endings as words and measures by name."""
    fields = [("episode", "i8"), ("transitions", "i8"), ("steps", "i8"), ("minutes", "f8"),
              ("reward", "f8"), *([("average_reward", "f8")] if with_average else []),
              ("falls", "i4"), ("ending", ENDINGS.dtype)]
    table = np.zeros(len(rows), fields + [(key, "f8") for key in measures])
    for name in ("episode", "transitions", "steps", "reward", "average_reward", "falls"):
        if name in table.dtype.names:
            table[name] = rows[name]
    table["minutes"] = rows["steps"] * step_time / 60 if step_time else np.nan
    table["ending"] = ENDINGS[rows["ending"]]
    for i, key in enumerate(measures):
        table[key] = rows["measures"][:, i]
    return table
