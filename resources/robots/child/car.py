# SPDX-License-Identifier: GPL-3.0-or-later
"""The car in the valley (Sutton & Barto, example 10.1), as a program that moves a robot of Surefoot."""
import math

import surefoot_child


class Car:
    def reset(self, random, parameters):
        self.power = parameters["power"]
        self.x, self.v = random.uniform(-0.6, -0.4), 0.0
        return {"position": self.x, "speed": self.v}

    def step(self, levels):
        self.v += self.power * levels["throttle"] - 0.0025 * math.cos(3 * self.x)
        self.v = min(max(self.v, -0.07), 0.07)
        self.x = min(max(self.x + self.v, -1.2), 0.5)
        if self.x == -1.2:
            self.v = 0.0
        return {"position": self.x, "speed": self.v}, -1, self.x >= 0.5, False


surefoot_child.serve(Car())
