# SPDX-License-Identifier: GPL-3.0-or-later
"""Moves a robot of Surefoot from Python ("surefoot child 1"; physics/robot/child/frames.h has the frames).

    import surefoot_child
    class Car:
        def reset(self, random, parameters):        # a random.Random for this episode; {"power": 0.001}
            return {"x": -0.5, "v": 0.0}            # the numbers that the robot's file names
        def step(self, levels):                     # {"push": 1.0}
            return {"x": ..., "v": ...}, reward, terminated, truncated
    surefoot_child.serve(Car())

What is printed goes to standard error. All chance has to come from `random`, and a reset forgets everything before.
"""
import os
import random
import struct
import sys


def serve(robot):
    """Answers until Surefoot hangs up. `robot` is as above; numbers may also be a list in the order of `sends`."""
    inp, out = os.dup(0), os.dup(1)
    os.dup2(2, 1)  # print() must not mix with the frames
    sys.stdout = sys.stderr

    buffer = b""

    def read(size):
        nonlocal buffer
        while len(buffer) < size:
            part = os.read(inp, 65536)
            if not part:
                os._exit(0)
            buffer += part
        data, buffer = buffer[:size], buffer[size:]
        return data

    def write(kind, data):
        data = struct.pack("<II", kind, len(data)) + data
        while data:
            data = data[os.write(out, data):]

    def packed(numbers, *before):
        row = [numbers[name] for name in sends] if isinstance(numbers, dict) else list(numbers)
        if len(row) != len(sends):
            raise ValueError(f"{len(row)} numbers, but the file names {len(sends)}: {' '.join(sends)}")
        return struct.pack(f"<{len(before) + len(row)}d", *map(float, before), *map(float, row))

    try:
        while True:
            kind, size = struct.unpack("<II", read(8))
            data = read(size)
            if kind == 1:
                lines = [line.split() for line in data.decode().splitlines()[1:]]
                sends, names, keys = (next(l[1:] for l in lines if l[0] == w) for w in ("sends", "levels", "parameters"))
                write(1, b"surefoot child 1")
            elif kind == 2:
                chance = random.Random(int.from_bytes(data[:32], "little"))
                parameters = dict(zip(keys, struct.unpack(f"<{len(keys)}d", data[32:])))
                write(2, packed(robot.reset(chance, parameters)))
            else:
                levels = dict(zip(names, struct.unpack(f"<{len(names)}d", data)))
                numbers, reward, terminated, truncated = robot.step(levels)
                write(3, packed(numbers, reward, bool(terminated), bool(truncated)))
    except Exception as error:  # told in Surefoot
        write(4, f"{type(error).__name__}: {error}".encode()[:4000])
        raise


class Gymnasium:
    """An environment with the interface of Gymnasium. `action` makes its action from the levels; as it stands, the one
    level as a whole number. `before` may set parameters of the environment: before(environment, parameters)."""

    def __init__(self, environment, action=lambda levels: int(next(iter(levels.values()))), before=None):
        self.environment, self.action, self.before = environment, action, before

    def reset(self, chance, parameters):
        if self.before:
            self.before(self.environment, parameters)
        observation, _ = self.environment.reset(seed=chance.getrandbits(31))
        return list(observation)

    def step(self, levels):
        observation, reward, terminated, truncated, _ = self.environment.step(self.action(levels))
        return list(observation), reward, terminated, truncated
