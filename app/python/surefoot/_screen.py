# SPDX-License-Identifier: GPL-3.0-or-later
"""A window of Matplotlib that shows a robot about as fast as it is."""

from __future__ import annotations

import time
from typing import Any

import numpy as np

from ._errors import MissingError

PICTURES = 30  # a second


class Screen:
    """Shows pictures; opened by the first, and again if it was closed by hand."""

    def __init__(self) -> None:
        try:
            import matplotlib.pyplot as pyplot
        except ImportError:
            raise MissingError('render_mode = "human" needs Matplotlib (Debian: python3-matplotlib,'
                               ' elsewhere: pip install matplotlib).') from None
        self._pyplot = pyplot
        self._figure: Any = None
        self._image: Any = None
        self.begin()

    def begin(self) -> None:
        """An episode begins: from here simulated time is counted."""
        self._begun, self._simulated, self._shown = time.monotonic(), 0.0, 0.0

    def due(self, seconds: float, last: bool) -> bool:
        """The robot has moved on by so much; whether the next picture is due."""
        self._simulated += seconds
        return last or self._simulated - self._shown >= 1 / PICTURES

    def show(self, picture: np.ndarray) -> None:
        """Shows uint8 [height, width, 3], and waits until the robot's time has come."""
        if self._figure is None or not self._pyplot.fignum_exists(self._figure.number):
            height, width = picture.shape[:2]
            self._figure = self._pyplot.figure("Surefoot", figsize=(width / 100, height / 100),
                                               dpi=100)
            axes = self._figure.add_axes([0, 0, 1, 1])
            axes.set_axis_off()
            self._image = axes.imshow(picture)
            if self._pyplot.get_backend().lower() != "agg":
                self._figure.show()
        self._image.set_data(picture)
        self._shown = self._simulated
        canvas = self._figure.canvas
        canvas.draw()
        canvas.flush_events()
        ahead = self._begun + self._simulated - time.monotonic()
        if 0 < ahead < 1:
            time.sleep(ahead)

    def close(self) -> None:
        """Closes the window."""
        if self._figure is not None:
            self._pyplot.close(self._figure)
            self._figure = self._image = None
