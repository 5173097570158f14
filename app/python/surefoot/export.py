# SPDX-License-Identifier: GPL-3.0-or-later
"""Results and roll-outs in the formats of other tools.

``tensorboard(source, folder)``, ``parquet(source, file)``, ``minari(file, environment, policy)``.
"""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any, Callable

import numpy as np

from ._descriptions import whole_number
from ._environment import Environment
from ._errors import ArgumentTypeError, FileError, MissingError, UsageError
from ._learned import Learned
from ._life import Life
from ._results import conditions, episodes, lives

__all__ = ["minari", "parquet", "tensorboard"]


def tensorboard(source: Any, folder: str | os.PathLike) -> None:
    """Writes learning curves for TensorBoard: `tensorboard --logdir FOLDER` shows them.

    `source`: a life, or a store; of a store every life becomes a run, CONDITION/LIFE. A run has
    "reward", "transitions" and "falls" (so far) over the steps of the life.
    Needs tensorboardX, or PyTorch with tensorboard.
    """
    writer = _summary_writer()
    folder = Path(folder)
    if isinstance(source, Life):
        _write_run(writer, folder, source.episodes())
        return
    names = [c["name"] for c in conditions(source)]
    table = episodes(source)
    for condition, life in np.unique(table[["condition", "life"]]):
        rows = table[(table["condition"] == condition) & (table["life"] == life)]
        name = "".join(c if c.isalnum() or c in " .-_" else "_" for c in names[condition])
        _write_run(writer, folder / f"{condition} {name}" / str(life), rows)


def parquet(source: Any, file: str | os.PathLike, table: str = "episodes") -> None:
    """Writes a table as Parquet to a file that must not exist yet. Needs pyarrow.

    `source`: a life (its episodes), or a store; `table`: "episodes" or "lives" of a store.
    """
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError:
        raise MissingError("export.parquet() needs pyarrow (pip install pyarrow).") from None
    if table not in ("episodes", "lives"):
        raise UsageError(f'table = {table!r}; allowed are "episodes" and "lives".')
    if isinstance(source, Life):
        rows = source.episodes()
    else:
        rows = episodes(source) if table == "episodes" else lives(source)
    columns = {name: rows[name].tolist() if rows.dtype[name].kind == "U" else
               np.ascontiguousarray(rows[name]) for name in rows.dtype.names}
    _whole(file, lambda out: pyarrow.parquet.write_table(pyarrow.table(columns), out))


def minari(file: str | os.PathLike, environment: Environment, policy: Any = None, *,
           count: int = 10, seed: int = 1, most_steps: int = 100_000) -> dict[str, Any]:
    """Rolls episodes out and writes them as NPZ, named as a Minari data set names them.

    `policy`: a life or a Q-function (its greedy action: the first of those with the largest value),
    a function from a state to an action, or None: actions by chance. `count`: episodes; the i-th
    begins with ``reset(seed=seed + i)``. One that is longer than `most_steps` is cut off.

    The file, which must not exist yet, has for every episode ``episode_0/observations`` [steps + 1,
    state variables], ``…/actions``, ``…/rewards``, ``…/terminations``, ``…/truncations``,
    ``…/infos/fall`` [steps], and ``metadata``, a text of JSON. Gives that as a dictionary.
    """
    if not isinstance(environment, Environment):
        unwrapped = getattr(environment, "unwrapped", None)
        if not isinstance(unwrapped, Environment):
            raise ArgumentTypeError(f"environment = {environment!r} must come from make().")
        environment = unwrapped
    count = whole_number(count, "count", 1, 1_000_000)
    seed = whole_number(seed, "seed", 0, 2**64 - count)
    most_steps = whole_number(most_steps, "most_steps", 1, 10**9)
    act = _action_from(policy, environment, seed)
    arrays: dict[str, np.ndarray] = {}
    steps = falls = 0
    for i in range(count):
        episode = _roll_out(environment, act, seed + i, most_steps)
        steps, falls = steps + len(episode["actions"]), falls + int(episode["infos/fall"].sum())
        arrays.update({f"episode_{i}/{name}": array for name, array in episode.items()})
    about = environment.about
    metadata = {"total_episodes": count, "total_steps": steps, "falls": falls, "seed": seed,
                "environment": {k: about[k] for k in ("environment", "preset", "scenario",
                                                      "parameters")},
                "state": about["state"], "actions": about["actions"]}
    arrays["metadata"] = np.array(json.dumps(metadata))
    _whole(file, lambda out: np.savez_compressed(out, **arrays))
    return metadata


def _action_from(policy: Any, environment: Environment, seed: int) -> Callable[[np.ndarray], int]:
    if policy is None:
        random = np.random.default_rng(seed)
        actions = int(environment.action_space.n)
        return lambda state: int(random.integers(actions))
    if isinstance(policy, Learned):
        return lambda state: int(policy.values(state).argmax())
    if callable(policy):
        return policy
    raise ArgumentTypeError(f"policy = {policy!r} must be a life, a Q-function, a function, None.")


def _roll_out(environment: Environment, act: Callable[[np.ndarray], int], seed: int,
              most_steps: int) -> dict[str, np.ndarray]:
    state, _ = environment.reset(seed=seed)
    states, rows = [state], []
    over = False
    while not over:
        action = act(state)
        state, reward, terminated, truncated, info = environment.step(action)
        truncated = truncated or (not terminated and len(rows) + 1 >= most_steps)
        over = terminated or truncated
        states.append(state)
        rows.append((action, reward, terminated, truncated, info["fall"]))
    actions, rewards, terminations, truncations, falls = zip(*rows)
    return {"observations": np.array(states), "actions": np.array(actions, np.int64),
            "rewards": np.array(rewards), "terminations": np.array(terminations),
            "truncations": np.array(truncations), "infos/fall": np.array(falls)}


def _summary_writer() -> Any:
    for module in ("tensorboardX", "torch.utils.tensorboard"):
        try:
            return __import__(module, fromlist=["SummaryWriter"]).SummaryWriter
        except ImportError:
            continue
    raise MissingError("export.tensorboard() needs tensorboardX (pip install tensorboardX), or "
                       "PyTorch with tensorboard.")


def _write_run(writer: Any, folder: Path, rows: np.ndarray) -> None:
    run = writer(str(folder))
    falls = np.cumsum(rows["falls"])
    for row, so_far in zip(rows, falls):
        step = int(row["steps"])
        run.add_scalar("reward", float(row["reward"]), step)
        run.add_scalar("transitions", int(row["transitions"]), step)
        run.add_scalar("falls", int(so_far), step)
    run.close()


def _whole(file: str | os.PathLike, write: Callable[[Any], None]) -> None:
    """A file that does not exist yet is written whole, or not at all."""
    try:
        with open(file, "xb") as out:
            try:
                write(out)
            except BaseException:
                os.unlink(file)
                raise
    except FileExistsError:
        raise FileError(f"{os.fspath(file)} exists already; it is not written over.") from None
    except OSError as error:
        raise FileError(f"{os.fspath(file)} cannot be written: {error.strerror or error}."
                        ) from None
