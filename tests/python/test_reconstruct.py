"""Scenes of depth frames are those that the command makes."""

import functools
import unittest

import numpy as np

import symscene
from support import FolderTest


@functools.lru_cache(maxsize=None)
def sweep():
    return symscene.example_sweep(8)


class Reconstruct(FolderTest):
    def setUp(self):
        super().setUp()
        depths, poses, camera = sweep()
        writer = symscene.SequenceWriter(self.folder / "sweep", camera)
        for number, (depth, pose) in enumerate(zip(depths, poses)):
            writer.add(symscene.Frame(depth, None, pose, number / 30.0))
        writer.finish()

    def test_of_a_sequence_is_the_scene_that_the_command_writes(self):
        self.run_command("reconstruct", "sweep", "-o", "by_command")
        scene = symscene.reconstruct(symscene.open_sequence(self.folder / "sweep"))
        symscene.write_scene(self.folder / "by_python", scene)
        self.assert_same_files(
            self.folder / "by_command",
            self.folder / "by_python",
            leave_out={"scene.json"},
        )

    def test_of_arrays_is_that_of_their_sequence(self):
        sequence = symscene.open_sequence(self.folder / "sweep")
        steps = []
        by_arrays = symscene.reconstruct(
            iter(sweep()[0]),
            (525.0, 525.0, 319.5, 239.5),
            sensor="structured-light",
            progress=steps.append,
        )
        by_sequence = symscene.reconstruct(sequence, sensor="structured-light", threads=1)
        np.testing.assert_array_equal(by_arrays.mesh.vertices, by_sequence.mesh.vertices)
        np.testing.assert_array_equal(by_arrays.cloud.points, by_sequence.cloud.points)
        self.assertEqual(steps[0], "frame 1")
        self.assertEqual(len(steps), len(sequence) + 1)

    def test_with_exact_poses_keeps_them(self):
        sequence = symscene.open_sequence(self.folder / "sweep")
        scene = symscene.reconstruct(sequence, pose_use="exact")
        poses = [frame.T_world_camera for frame in sequence]
        np.testing.assert_allclose(scene.T_world_cameras, poses, atol=1e-12)

    def test_tracks_the_camera_of_the_sweep(self):
        depths, poses, camera = sweep()
        scene = symscene.reconstruct(depths, camera)
        self.assertEqual(scene.warnings, [])
        moved = np.linalg.inv(poses[0]) @ np.array(poses)  # the first camera is at the origin
        errors = np.linalg.norm(scene.T_world_cameras[:, :3, 3] - moved[:, :3, 3], axis=1)
        self.assertLess(errors.max(), 0.01)
        self.assertEqual(len(symscene.segment(scene).objects), 3)

    def test_of_one_frame_takes_its_own_pixels(self):
        depth, camera = symscene.example_depth()
        scene = symscene.reconstruct([depth], camera)
        view = symscene.segment_depth(depth, camera).scene
        np.testing.assert_array_equal(scene.cloud.points, view.cloud.points)

    def test_incrementally_reports_each_frame(self):
        sequence = symscene.open_sequence(self.folder / "sweep")
        reconstruction = symscene.Reconstruction(sequence.camera)
        with self.assertRaises(symscene.InputError):
            reconstruction.scene()
        for number, frame in enumerate(sequence, start=1):
            report = reconstruction.add(frame, frame.T_world_camera)
            self.assertEqual((report.status, report.fused), ("converged", True))
            self.assertEqual(len(reconstruction.T_world_cameras), number)
            if number == 4:
                break
        self.assertGreater(len(reconstruction.mesh().vertices), 1000)
        with self.assertRaises(symscene.InputError):
            reconstruction.add(np.ones((3, 3)))


if __name__ == "__main__":
    unittest.main()
