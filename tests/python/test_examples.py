"""The numbered examples run, and they and the package are typed."""

import ast
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import symscene
from symscene import _symscene

EXAMPLES = pathlib.Path(os.environ["SYMSCENE_SOURCE_DIR"]) / "python" / "examples"


def has(module):
    return importlib.util.find_spec(module) is not None


def run(*arguments):
    return subprocess.run(
        [sys.executable, *map(str, arguments)], capture_output=True, text=True, check=False
    )


class Examples(unittest.TestCase):
    def output_of(self, name, *arguments):
        done = run(EXAMPLES / name, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_finds_objects_in_a_depth_image(self):
        self.assertEqual(self.output_of("1_depth_image.py").count("<SceneObject"), 3)

    @unittest.skipUnless(has("matplotlib"), "python3-matplotlib is not installed")
    def test_draws_a_result(self):
        with tempfile.TemporaryDirectory() as folder:
            image = pathlib.Path(folder) / "objects.png"
            self.output_of("2_show_in_matplotlib.py", image)
            self.assertEqual(image.read_bytes()[:4], b"\x89PNG")

    def test_makes_a_scene_of_a_sweep(self):
        told = self.output_of("3_sweep.py")
        self.assertNotIn("lost", told)
        self.assertEqual(told.count("<SceneObject"), 3)

    def test_completes_a_partial_scan(self):
        self.assertIn("axis through", self.output_of("4_symmetries.py"))


class Types(unittest.TestCase):
    @unittest.skipUnless(has("mypy"), "mypy is not installed")
    def test_of_the_examples_and_the_package_are_strict(self):
        package = pathlib.Path(symscene.__file__).parent
        done = run("-m", "mypy", "--strict", "--ignore-missing-imports", "--scripts-are-modules",
                   *sorted(EXAMPLES.glob("*.py")), package)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_of_the_stubs_have_the_names_of_the_module(self):
        stubs = ast.parse((pathlib.Path(symscene.__file__).parent / "_symscene.pyi").read_text())
        told = {}
        for node in stubs.body:
            if isinstance(node, ast.ClassDef):
                told[node.name] = {f.name for f in node.body if isinstance(f, ast.FunctionDef)}
            elif isinstance(node, ast.FunctionDef):
                told[node.name] = set()
        module = {name: value for name, value in vars(_symscene).items() if name[0] != "_"}
        self.assertEqual(set(told), set(module))
        for name, names in told.items():
            if name == "InputError" or not isinstance(module[name], type):
                continue
            own = {n for n in vars(module[name]) if n[0] != "_" or n in ("__len__", "__iter__", "__getitem__")}
            self.assertEqual(names - {"__init__"}, own, name)


if __name__ == "__main__":
    unittest.main()
