"""CMake installs the package where the interpreter looks for packages."""

import os
import pathlib
import site
import subprocess
import sys
import tempfile
import unittest

BUILD = os.environ["SYMSCENE_BUILD_DIR"]
FOLDER = os.environ["SYMSCENE_PYTHON_DIR"]


class Install(unittest.TestCase):
    def test_puts_the_package_into_the_folder_for_packages(self):
        with tempfile.TemporaryDirectory() as prefix:
            command = ["cmake", "--install", BUILD, "--prefix", prefix, "--component", "python"]
            subprocess.run(command, check=True, capture_output=True)
            folder = pathlib.Path(prefix) / FOLDER
            for path in pathlib.Path(prefix).rglob("*"):
                if path.is_file():
                    self.assertIn(folder / "symscene", path.parents)
            self.assertTrue((folder / "symscene" / "py.typed").exists())
            told = subprocess.run(
                [sys.executable, "-c", "import symscene; print(symscene.__file__)"],
                check=True,
                capture_output=True,
                text=True,
                cwd=prefix,
                env={**os.environ, "PYTHONPATH": str(folder)},
            )
            self.assertEqual(told.stdout.strip(), str(folder / "symscene" / "__init__.py"))

    def test_folder_is_searched_under_the_default_prefix(self):
        if not sys.executable.startswith("/usr/bin/"):
            self.skipTest("the interpreter is not that of the distribution")
        self.assertIn(f"/usr/local/{FOLDER}", site.getsitepackages())


if __name__ == "__main__":
    unittest.main()
