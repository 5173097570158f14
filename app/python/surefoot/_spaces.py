# SPDX-License-Identifier: GPL-3.0-or-later
"""What environments are made of: Gymnasium's classes, or small ones that look the same."""

from __future__ import annotations

import enum
import secrets
from typing import Any, Dict, Optional, Tuple

import numpy as np

try:
    import gymnasium
    from gymnasium import Env
    from gymnasium.spaces import Box, Discrete, MultiDiscrete
    from gymnasium.vector import VectorEnv
    from gymnasium.vector.utils import batch_space
    try:
        from gymnasium.vector import AutoresetMode
    except ImportError:  # before 1.1
        gymnasium = None
except ImportError:
    gymnasium = None

__all__ = ["AutoresetMode", "Box", "Discrete", "Env", "MultiDiscrete", "VectorEnv", "batch_space",
           "gymnasium"]

if gymnasium is None:
    class _Space:
        """A set of values that can be sampled."""

        def __init__(self, shape: Tuple[int, ...], dtype: Any, seed: Optional[int]) -> None:
            self.shape, self.dtype = shape, np.dtype(dtype)
            self._np_random: Optional[np.random.Generator] = None
            if seed is not None:
                self.seed(seed)

        @property
        def np_random(self) -> np.random.Generator:
            """Random numbers of this space alone."""
            if self._np_random is None:
                self.seed()
            return self._np_random

        def seed(self, seed: Optional[int] = None) -> int:
            """Samples begin anew from `seed`; None: from one drawn by chance, which is returned."""
            seed = secrets.randbits(63) if seed is None else seed
            self._np_random = np.random.default_rng(seed)
            return seed

        def __contains__(self, value: Any) -> bool:
            return self.contains(value)

        def __eq__(self, other: Any) -> bool:
            return type(other) is type(self) and repr(other) == repr(self)

        __hash__ = None

    class Box(_Space):
        """Arrays of numbers between `low` and `high`, both of which may be infinite."""

        def __init__(self, low: Any, high: Any, shape: Optional[Tuple[int, ...]] = None,
                     dtype: Any = np.float32, seed: Optional[int] = None) -> None:
            shape = np.broadcast(low, high).shape if shape is None else tuple(shape)
            super().__init__(shape, dtype, seed)
            self.low = np.broadcast_to(low, shape).astype(self.dtype)
            self.high = np.broadcast_to(high, shape).astype(self.dtype)
            self.bounded_below = np.isfinite(self.low)
            self.bounded_above = np.isfinite(self.high)

        def sample(self) -> np.ndarray:
            """Uniform where bounded, else exponential or normal."""
            r = self.np_random
            below, above = self.bounded_below, self.bounded_above
            value = np.where(below, self.low + r.exponential(size=self.shape),
                             np.where(above, self.high - r.exponential(size=self.shape),
                                      r.normal(size=self.shape)))
            inside = below & above
            value[inside] = r.uniform(self.low[inside], self.high[inside])
            return value.astype(self.dtype)

        def contains(self, value: Any) -> bool:
            """Whether the value is an array of this shape, of no wider type, within the bounds."""
            return bool(isinstance(value, np.ndarray) and np.can_cast(value.dtype, self.dtype) and
                        value.shape == self.shape and (value >= self.low).all() and
                        (value <= self.high).all())

        def __repr__(self) -> str:
            return f"Box({self.low}, {self.high}, {self.shape}, {self.dtype})"

    class Discrete(_Space):
        """The whole numbers start … start + n − 1."""

        def __init__(self, n: int, seed: Optional[int] = None, start: int = 0) -> None:
            super().__init__((), np.int64, seed)
            self.n, self.start = np.int64(n), np.int64(start)

        def sample(self) -> np.int64:
            """Each as likely as the others."""
            return self.start + self.np_random.integers(self.n)

        def contains(self, value: Any) -> bool:
            """Whether the value is one of them."""
            whole = isinstance(value, (int, np.integer)) or (
                isinstance(value, np.ndarray) and value.shape == () and value.dtype.kind in "iu")
            return bool(whole and self.start <= value < self.start + self.n)

        def __repr__(self) -> str:
            return f"Discrete({self.n})" if not self.start else \
                f"Discrete({self.n}, start={self.start})"

    class MultiDiscrete(_Space):
        """Arrays of whole numbers, each from 0 to one below that of `nvec`."""

        def __init__(self, nvec: Any, dtype: Any = np.int64, seed: Optional[int] = None) -> None:
            self.nvec = np.array(nvec, dtype=dtype)
            super().__init__(self.nvec.shape, dtype, seed)

        def sample(self) -> np.ndarray:
            """Each as likely as the others."""
            return self.np_random.integers(self.nvec, dtype=self.dtype)

        def contains(self, value: Any) -> bool:
            """Whether the value is one of them."""
            return bool(isinstance(value, np.ndarray) and value.shape == self.shape and
                        value.dtype.kind in "iu" and (value >= 0).all() and
                        (value < self.nvec).all())

        def __repr__(self) -> str:
            return f"MultiDiscrete({self.nvec})"

    def batch_space(space: _Space, n: int) -> _Space:
        """The space of `n` values side by side."""
        if isinstance(space, Discrete):
            return MultiDiscrete(np.full(n, space.n))
        return Box(np.repeat(space.low[None], n, 0), np.repeat(space.high[None], n, 0),
                   dtype=space.dtype)

    class AutoresetMode(enum.Enum):
        """What becomes of a world whose episode is over."""

        NEXT_STEP = "NextStep"
        SAME_STEP = "SameStep"
        DISABLED = "Disabled"

    class _Seeded:
        """Random numbers of Python's side."""

        _np_random: Optional[np.random.Generator] = None
        _np_random_seed: Optional[int] = None

        def reset(self, *, seed: Optional[int] = None,
                  options: Optional[Dict[str, Any]] = None) -> None:
            if seed is not None:
                self._np_random, self._np_random_seed = np.random.default_rng(seed), seed

        @property
        def np_random(self) -> np.random.Generator:
            """Random numbers for what is written around the environment; it has its own."""
            if self._np_random is None:
                _Seeded.reset(self, seed=secrets.randbits(63))
            return self._np_random

        @np_random.setter
        def np_random(self, value: np.random.Generator) -> None:
            self._np_random, self._np_random_seed = value, -1

        @property
        def np_random_seed(self) -> int:
            """What the random numbers began with; −1: nobody knows."""
            if self._np_random_seed is None:
                _Seeded.reset(self, seed=secrets.randbits(63))
            return self._np_random_seed

    class Env(_Seeded):
        """The interface of gymnasium.Env."""

        metadata: Dict[str, Any] = {"render_modes": []}
        render_mode: Optional[str] = None
        spec = None

        @property
        def unwrapped(self) -> "Env":
            """Itself."""
            return self

        def close(self) -> None:
            """Nothing."""

        def __enter__(self) -> "Env":
            return self

        def __exit__(self, *_: Any) -> bool:
            self.close()
            return False

    class VectorEnv(_Seeded):
        """The interface of gymnasium.vector.VectorEnv."""

        metadata: Dict[str, Any] = {}
        render_mode: Optional[str] = None
        spec = None
        closed = False
        num_envs = 0

        @property
        def unwrapped(self) -> "VectorEnv":
            """Itself."""
            return self

        def close(self, **_: Any) -> None:
            """Once."""
            if not self.closed:
                self.close_extras()
                self.closed = True

        def close_extras(self) -> None:
            """Nothing."""
