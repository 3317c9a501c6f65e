"""What tests of the Python package share: results, folders, the command."""

import functools
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import symscene

COMMAND = os.environ.get("SYMSCENE_COMMAND", "")


@functools.lru_cache(maxsize=None)
def example_result():
    """The objects of the simulated depth image."""
    return symscene.segment_depth(*symscene.example_depth())


def objects_without_times(folder):
    objects = json.loads((pathlib.Path(folder) / "objects.json").read_text())
    objects.pop("timings", None)
    objects.pop("made_by", None)
    return objects


class FolderTest(unittest.TestCase):
    """A test with a temporary folder."""

    def setUp(self):
        self._temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self._temporary.cleanup)
        self.folder = pathlib.Path(self._temporary.name)

    def run_command(self, *arguments):
        if not COMMAND:
            self.skipTest("the command is not built")
        subprocess.run(
            [COMMAND, *map(str, arguments)], check=True, capture_output=True, cwd=self.folder
        )

    def assert_same_files(self, one, other, leave_out=()):
        """The same files with the same bytes; objects.json but for times and what made it."""
        names = [
            {str(p.relative_to(folder)) for p in folder.rglob("*") if p.is_file()} - set(leave_out)
            for folder in (one, other)
        ]
        self.assertEqual(names[0], names[1])
        for name in sorted(names[0]):
            if name == "objects.json":
                self.assertEqual(objects_without_times(one), objects_without_times(other))
            else:
                same = (one / name).read_bytes() == (other / name).read_bytes()
                self.assertTrue(same, name)
