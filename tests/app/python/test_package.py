# SPDX-License-Identifier: GPL-3.0-or-later
"""The package as a reader meets it: help, lines, and what it says where its library is missing."""

import inspect
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import support
import surefoot

PACKAGE = Path(surefoot.__file__).parent


class Package(support.Folder):
    def test_everything_has_words(self):
        self.assertGreater(len(surefoot.__doc__), 1000)
        for name in surefoot.__all__:
            thing = getattr(surefoot, name)
            self.assertTrue(inspect.getdoc(thing), name)
            if not inspect.isclass(thing):
                continue
            for member, value in vars(thing).items():
                if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                    self.assertTrue(inspect.getdoc(value), f"{name}.{member}")

    def test_lines_end_at_100_columns(self):
        folders = (PACKAGE, PACKAGE.parent / "notebooks", Path(__file__).parent)
        for file in (f for folder in folders for f in folder.glob("*.py")):
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                self.assertLessEqual(len(line), 100, f"{file}:{number}")
            self.assertIn("SPDX-License-Identifier", file.read_text(encoding="utf-8")[:100])

    def test_every_call_of_the_header_is_declared(self):
        from surefoot import _library
        header = (support.SOURCE / "app" / "library" / "surefoot.h").read_text(encoding="utf-8")
        there = set(re.findall(r"^SUREFOOT_\w+ surefoot_status surefoot_(\w+)\(", header, re.M))
        self.assertEqual(there, set(_library._CALLS))
        self.assertIn(f"#define SUREFOOT_API {_library.API}\n", header)
        for call, arguments in _library._CALLS.items():
            declared = re.search(rf"surefoot_{call}\((.*?)\);", header, re.S)[1]
            declared = re.sub(r"\(\*\w+\)\([^)]*\)", "", declared)  # of a function as an argument
            self.assertEqual(len(declared.split(",")), len(arguments), call)

    def test_the_structures_are_those_of_the_header(self):
        """Their sizes, asked from a C compiler, where there is one."""
        compiler = shutil.which("cc")
        if not compiler:
            self.skipTest("no compiler")
        import ctypes

        from surefoot import _library as l
        from surefoot._episodes import EPISODE
        names = {"outcome": l.Outcome, "batch": l.Batch, "world": l.World, "policy": l.Policy,
                 "extent": l.Extent, "totals": l.CTotals, "progress": l.CProgress}
        sizes = {name: ctypes.sizeof(kind) for name, kind in names.items()}
        sizes["episode"] = EPISODE.itemsize
        code = '#include "app/library/surefoot.h"\n' + "\n".join(
            f'_Static_assert(sizeof(surefoot_{name}) == {size}, "{name}");'
            for name, size in sizes.items())
        done = subprocess.run([compiler, "-std=c11", "-fsyntax-only", "-x", "c", "-I",
                               str(support.SOURCE), "-"], input=code, text=True,
                              capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_library_that_is_none(self):
        for library in ("/nowhere/libsurefoot.so", "libm.so.6", str(self.folder)):
            done = support.python("import surefoot", env={"SUREFOOT_LIBRARY": library})
            self.assertEqual(done.returncode, 1)
            self.assertIn("MissingError: the C library of Surefoot was not found: " + library,
                          done.stderr)
            self.assertIn("SUREFOOT_LIBRARY can name it", done.stderr)
            self.assertIn("--target surefoot_library` builds it", done.stderr)

    def test_its_version_is_that_of_the_program(self):
        version = re.search(r"project\(surefoot VERSION (\S+)",
                            (support.SOURCE / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
        self.assertEqual(surefoot.__version__, version)
        project = (support.SOURCE / "app" / "python" / "pyproject.toml").read_text(encoding="utf-8")
        self.assertIn(f'version = "{version}"\n', project)

    def test_it_is_found_beside_the_package(self):
        library = os.environ.get("SUREFOOT_LIBRARY")
        if not library:
            self.skipTest("SUREFOOT_LIBRARY is not set")
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(PACKAGE, Path(folder) / "surefoot")
            shutil.copy(library, Path(folder) / "surefoot" / "libsurefoot.so.1")
            env = {"PYTHONPATH": folder, "SUREFOOT_LIBRARY": ""}
            done = support.python("import surefoot; surefoot.make('cliff'); "
                                  "print(surefoot.__file__)", env=env)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(folder, done.stdout)


if __name__ == "__main__":
    unittest.main()
