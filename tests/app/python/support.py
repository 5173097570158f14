# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the package share. Where NumPy is missing, a test file is skipped (77)."""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[3]

try:
    import numpy as np
except ImportError:
    print("NumPy is missing: skipped")
    sys.exit(77)

import surefoot  # noqa: E402

PROGRAM = os.environ.get("SUREFOOT_PROGRAM", str(SOURCE / "build" / "release" / "surefoot"))
ROBOTS = SOURCE / "resources" / "robots"


def train(*arguments):
    """What `surefoot train --json` prints."""
    done = subprocess.run([PROGRAM, "train", "--json", *map(str, arguments)], check=True,
                          capture_output=True, text=True)
    return json.loads(done.stdout)


class Folder(unittest.TestCase):
    """A test with a folder of its own, `self.folder`, and hints at sentences."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)

    def refused(self, kind, *words):
        """``with self.refused(KIND, WORDS…):`` an error of this package with a plain sentence."""
        return _Refused(self, kind, words)


class _Refused:
    def __init__(self, test, kind, words):
        self.test, self.kind, self.words = test, kind, words

    def __enter__(self):
        return self

    def __exit__(self, kind, error, _):
        self.test.assertIsNotNone(kind, "nothing was raised")
        if not issubclass(kind, self.kind):
            return False
        self.test.assertIsInstance(error, surefoot.Error)
        self.test.assertGreater(len(str(error)), 10)
        for word in self.words:
            self.test.assertIn(word, str(error))
        return True


def python(code, *, env=None, timeout=60, **more):
    """Runs another interpreter with this package."""
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                          timeout=timeout, env={**os.environ, **(env or {})}, **more)
