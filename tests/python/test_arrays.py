"""Arrays of results are read-only views whose memory outlives the result."""

import gc
import unittest

import numpy as np

import symscene
from support import example_result


class Arrays(unittest.TestCase):
    def arrays(self):
        result = example_result()
        item = result.objects[0]
        return {
            "points": result.points,
            "normals": result.cloud.normals,
            "labels": result.label_image,
            "mask": item.indices,
            "object": item.points,
            "completed": item.completed.points,
            "vertices": item.mesh.vertices,
            "triangles": item.mesh.triangles,
            "observed": item.observed_triangles,
        }

    def test_are_views_without_a_copy(self):
        for (name, first), second in zip(self.arrays().items(), self.arrays().values()):
            self.assertTrue(np.shares_memory(first, second), name)
            self.assertFalse(first.flags.owndata, name)
            self.assertIsNotNone(first.base, name)

    def test_are_read_only(self):
        for name, array in self.arrays().items():
            with self.assertRaises(ValueError, msg=name):
                array[0] = 0
            with self.assertRaises(ValueError, msg=name):
                array.flags.writeable = True

    def test_have_the_shapes_and_types_of_the_docstrings(self):
        arrays = self.arrays()
        count = len(arrays["points"])
        self.assertEqual(arrays["points"].shape, (count, 3))
        self.assertEqual(arrays["points"].dtype, np.float32)
        self.assertEqual(arrays["mask"].dtype, np.uint32)
        self.assertEqual(arrays["labels"].shape, (480, 640))
        self.assertEqual(arrays["labels"].dtype, np.uint16)
        self.assertEqual(arrays["triangles"].shape, (len(arrays["observed"]), 3))
        self.assertLess(arrays["triangles"].max(), len(arrays["vertices"]))

    def test_keep_the_memory_of_a_deleted_result(self):
        points = np.random.default_rng(1).random((1000, 3), dtype=np.float32)
        cloud = symscene.PointCloud(points)
        kept = cloud.points
        del cloud
        gc.collect()
        others = [symscene.PointCloud(points + k) for k in range(20)]  # would reuse the memory
        np.testing.assert_array_equal(kept, points)
        self.assertEqual(len(others), 20)

    def test_of_an_object_are_the_points_of_its_mask(self):
        result = example_result()
        for item in result.objects:
            np.testing.assert_array_equal(item.points, result.points[item.indices])
            np.testing.assert_array_equal(np.sort(item.indices), item.indices)

    def test_without_values_are_empty(self):
        cloud = symscene.PointCloud(np.zeros((2, 3)))
        self.assertEqual(cloud.normals.shape, (0, 3))
        self.assertEqual(cloud.colors.shape, (0, 3))


if __name__ == "__main__":
    unittest.main()
