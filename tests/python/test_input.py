"""Invalid input raises InputError with one sentence that names it."""

import pathlib
import unittest

import numpy as np

import symscene

CAMERA = (525.0, 525.0, 1.5, 1.5)
DEPTH = np.full((4, 4), 1000, np.uint16)
POINTS = np.zeros((10, 3), np.float32)


class InvalidInput(unittest.TestCase):
    def refused(self, sentence, function, *arguments, **keywords):
        with self.assertRaises(symscene.InputError) as raised:
            function(*arguments, **keywords)
        self.assertIn(sentence, str(raised.exception))
        error = raised.exception
        self.assertEqual(
            str(error), f"{error.where}: expected {error.expected}, found {error.found}"
        )

    def test_is_a_value_error(self):
        self.assertTrue(issubclass(symscene.InputError, ValueError))

    def test_of_a_shape_is_told(self):
        for points in (np.zeros((10, 2)), np.zeros(3), np.zeros((2, 2, 3))):
            self.refused("points: expected an array of numbers of shape (N, 3), found an array of "
                         f"shape {points.shape}", symscene.segment, points)
        self.refused("depth: expected a depth image", symscene.segment_depth, POINTS[0], CAMERA)
        self.refused("normals: expected as many rows", symscene.segment, POINTS, POINTS[:3])

    def test_of_a_type_is_told(self):
        for wrong in ("text", None, [["a", "b", "c"]], {}):
            self.refused("points: expected an array of numbers", symscene.segment, wrong)
        self.refused("found an array of shape (10, 3) and type bool",
                     symscene.segment, POINTS > 0)
        self.refused("colors: expected an array of uint8", symscene.segment, POINTS, colors=POINTS)

    def test_of_a_camera_is_told(self):
        for camera, sentence in (
            ((1.0, 2.0), "intrinsics: expected CameraIntrinsics, (fx, fy, cx, cy)"),
            ((0.0, 525.0, 1.5, 1.5), "intrinsics: expected focal lengths above 0"),
            ((525.0, 525.0, 99.0, 1.5), "intrinsics: expected a principal point in the image"),
            (symscene.CameraIntrinsics(8, 8, 5, 5, 4, 4), "depth: expected an image of 8x8 pixels"),
            (np.eye(3) + 1, "intrinsics: expected a matrix [[fx, 0, cx]"),
        ):
            self.refused(sentence, symscene.segment_depth, DEPTH, camera)

    def test_of_a_table_is_told(self):
        self.refused("table: expected 4 finite numbers", symscene.segment, POINTS, table=(0, 0, 1))
        self.refused("table: expected", symscene.segment, POINTS, table=(0, 0, 0, 1))
        self.refused("any_up: expected no table beside it", symscene.segment, POINTS,
                     table=False, any_up=True)

    def test_of_an_option_has_the_sentence_of_the_command(self):
        self.refused('options: expected a number in [0.0001, 1] m for "voxel_size", found -1',
                     symscene.segment, POINTS, voxel_size=-1)
        self.refused('options: expected a number for "voxel_size", found "nan"',
                     symscene.segment, POINTS, options={"voxel_size": float("nan")})
        self.refused("only options that --dump-config lists", symscene.segment, POINTS, voxel=1)
        self.refused('for "selection"', symscene.segment, POINTS, selection=3)
        self.refused("options: expected a dictionary", symscene.segment, POINTS, options=[1])
        self.refused("threads: expected", symscene.segment, POINTS, threads=-1)
        self.refused("progress: expected", symscene.segment, POINTS, progress=3)

    def test_of_a_file_names_it(self):
        missing = pathlib.Path("nowhere") / "cloud.ply"
        for read in (symscene.read_cloud, symscene.read_mesh, symscene.read_scene,
                     symscene.read_result, symscene.read_grasps, symscene.open_sequence):
            self.refused("nowhere", read, missing)

    def test_of_occupancy_is_told(self):
        states = np.zeros((2, 2, 2), np.uint8)
        self.refused("states", symscene.Occupancy, states + 3, 0.01, (0, 0, 0))
        self.refused("origin", symscene.Occupancy, states, 0.01, (0.005, 0, 0))
        self.refused("resolution", symscene.Occupancy, states, 0.0, (0, 0, 0))

    def test_of_triangles_is_told(self):
        self.refused("triangles: expected indices below 10", symscene.TriangleMesh, POINTS,
                     [[0, 1, 10]])


class Options(unittest.TestCase):
    def test_of_keywords_and_of_a_dictionary_are_one(self):
        rng = np.random.default_rng(2)
        points = np.concatenate([rng.random((3000, 2)) * 0.3, np.zeros((3000, 1))], axis=1)
        one = symscene.segment(points, table=False, voxel_size=0.02)
        other = symscene.segment(points, table=False, options={"voxel_size": np.float32(0.02)})
        self.assertAlmostEqual(len(one.points), len(other.points), delta=2)
        self.assertLess(len(one.points), 400)

    def test_have_defaults_and_descriptions(self):
        for function in ("segment", "symmetries", "partial_symmetries", "reconstruct", "grasps"):
            values = symscene.default_options(function)
            for option in symscene.describe_options(function):
                value = values
                for name in option.name.split("."):
                    value = value[name]
                self.assertEqual(value, option.default, option.name)
                self.assertTrue(option.help, option.name)


if __name__ == "__main__":
    unittest.main()
