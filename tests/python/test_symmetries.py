"""Symmetries of models, and what they complete."""

import json
import unittest

import numpy as np

import symscene
from support import FolderTest, example_result


def box_mesh(size):
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float) - 0.5
    triangles = []
    for axis in range(3):
        for side in (0, 1):
            a, b = [k for k in range(3) if k != axis]
            face = [np.eye(3, dtype=int)[axis] * side + np.eye(3, dtype=int)[a] * i
                    + np.eye(3, dtype=int)[b] * j for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
            ids = [4 * f[0] + 2 * f[1] + f[2] for f in face]
            normal = np.cross(corners[ids[1]] - corners[ids[0]], corners[ids[2]] - corners[ids[0]])
            if normal[axis] * (side - 0.5) < 0:
                ids.reverse()
            triangles += [[ids[0], ids[1], ids[2]], [ids[0], ids[2], ids[3]]]
    return symscene.TriangleMesh(corners * size, triangles)


class Symmetries(FolderTest):
    def test_of_a_box_are_three_planes_and_three_half_turns(self):
        group = symscene.symmetries(box_mesh([0.3, 0.2, 0.1]))
        self.assertEqual(len(group.planes), 3)
        self.assertEqual([axis.order for axis in group.axes], [2, 2, 2])
        self.assertEqual(group.rotations.shape, (3, 4, 4))
        normals = np.abs([plane.normal for plane in group.planes])
        np.testing.assert_allclose(normals.sum(axis=0), [1, 1, 1], atol=0.02)

    def test_are_those_that_the_command_finds(self):
        mesh = box_mesh([0.3, 0.2, 0.1])
        symscene.write_mesh(self.folder / "box.ply", mesh)
        self.run_command("symmetry", "box.ply", "-o", "box.json")
        told = json.loads((self.folder / "box.json").read_text())["models"][0]
        group = symscene.symmetries(mesh)
        self.assertEqual(len(told["planes"]), len(group.planes))
        for one, other in zip(told["planes"], group.planes):
            np.testing.assert_array_equal(one["normal"], other.normal)

    def test_of_half_a_cylinder_hold_its_axis(self):
        angle, z = np.meshgrid(np.linspace(-1.6, 1.6, 80), np.linspace(0, 0.12, 40))
        points = np.stack([0.04 * np.cos(angle), 0.04 * np.sin(angle), z], -1).reshape(-1, 3)
        normals = np.stack([np.cos(angle), np.sin(angle), 0 * z], -1).reshape(-1, 3)
        found = symscene.partial_symmetries(points, normals)
        self.assertEqual(len(found.axes), 1)
        self.assertGreater(abs(found.axes[0].direction[2]), 0.99)

        item = symscene.complete(points, normals, axes=found.axes, table=(0, 0, 1, 0))
        self.assertLess(item.completed.points[:, 0].min(), -0.035)
        self.assertIsNotNone(item.mesh)
        # The volume of the cylinder that the points show: within a tenth.
        self.assertAlmostEqual(item.solid.volume / (np.pi * 0.04**2 * 0.12), 1.0, delta=0.1)

    def test_complete_objects_to_closed_meshes(self):
        for item in example_result().objects:
            edges = np.sort(item.mesh.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
            _, counts = np.unique(edges, axis=0, return_counts=True)
            self.assertTrue(np.all(counts == 2))


if __name__ == "__main__":
    unittest.main()
