"""Objects of depth images, clouds and scenes are those that the command finds."""

import threading
import time
import unittest

import numpy as np

import symscene
from support import FolderTest, example_result, objects_without_times


class SegmentDepth(FolderTest):
    def test_finds_the_ball_the_box_and_the_cylinder(self):
        result = example_result()
        found = {item.symmetry_class.name: item.symmetry_class for item in result.objects}
        self.assertEqual(len(result.objects), 3)
        # Of the simulated scene, seen by a camera 0.6 m high that looks 40 degrees down.
        c, s = np.cos(np.radians(40.0)), np.sin(np.radians(40.0))
        R_world_camera = np.array([[1.0, 0.0, 0.0], [0.0, -s, c], [0.0, -c, -s]])
        true = {"sphere": [-0.17, 0.68, 0.05], "box": [0.02, 0.8, 0.06], "cylinder": [0.18, 0.65, 0.055]}
        self.assertEqual(set(found), set(true))
        for name, center in true.items():
            center_camera = (np.array(center) - [0.0, 0.0, 0.6]) @ R_world_camera
            np.testing.assert_allclose(found[name].center, center_camera, atol=0.005)
        radius = found["cylinder"].dimensions[0]
        self.assertEqual(radius.name, "radius")
        self.assertAlmostEqual(radius.value, 0.04, delta=0.001)

    def test_labels_the_pixels_of_its_objects(self):
        labels = example_result().label_image
        self.assertEqual(set(np.unique(labels)), {0, 1, 2, 3})
        depth, _ = symscene.example_depth()
        self.assertFalse(np.any((labels > 0) & (depth == 0)))

    def test_takes_metres_and_a_matrix_to_the_same_result(self):
        depth, camera = symscene.example_depth()
        K = np.array([[camera.fx, 0, camera.cx], [0, camera.fy, camera.cy], [0, 0, 1]])
        metres = depth.astype(np.float32) / np.float32(1000)
        metres[metres == 0] = np.nan
        other = symscene.segment_depth(metres, K)
        np.testing.assert_array_equal(other.label_image, example_result().label_image)
        np.testing.assert_array_equal(other.points, example_result().points)

    def test_writes_what_the_command_writes(self):
        depth, camera = symscene.example_depth()
        writer = symscene.SequenceWriter(self.folder / "view", camera)
        writer.add(symscene.Frame(depth))
        writer.finish()
        image = self.folder / "view" / "depth" / "000000.png"
        intrinsics = f"{camera.fx},{camera.fy},{camera.cx},{camera.cy}"
        self.run_command("segment", image, "--intrinsics", intrinsics, "-o", "by_command")
        symscene.write_result(self.folder / "by_python", example_result())
        self.assert_same_files(
            self.folder / "by_command", self.folder / "by_python", leave_out={"surface.ply"}
        )

    def test_does_not_depend_on_threads(self):
        other = symscene.segment_depth(*symscene.example_depth(), threads=1)
        symscene.write_result(self.folder / "one", other)
        symscene.write_result(self.folder / "all", example_result())
        self.assert_same_files(self.folder / "one", self.folder / "all")

    def test_tells_its_stages(self):
        stages = []
        symscene.segment_depth(*symscene.example_depth(), progress=stages.append)
        self.assertEqual(stages[0], "estimate sensor")
        self.assertIn("completion", stages)

    def test_ends_with_what_its_callback_raises(self):
        def stop(stage):
            if stage == "rotational detection":
                raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            symscene.segment_depth(*symscene.example_depth(), progress=stop)

    def test_lets_other_threads_run(self):
        counted, running = [], threading.Event()

        def count():
            while running.is_set():
                counted.append(time.monotonic())
                time.sleep(0.001)

        running.set()
        other = threading.Thread(target=count)
        other.start()
        begin = time.monotonic()
        stages = []
        symscene.segment_depth(
            *symscene.example_depth(), progress=lambda stage: stages.append(time.monotonic())
        )
        running.clear()
        other.join()
        # Within the longest stage, in which Python's code is not called.
        lengths = np.diff([begin, *stages])
        longest = int(np.argmax(lengths))
        low, high = [begin, *stages][longest : longest + 2]
        self.assertGreater(sum(low < at < high for at in counted), 3)


class Segment(FolderTest):
    def test_of_points_is_what_the_command_finds_in_their_cloud(self):
        view = example_result().scene
        symscene.write_cloud(self.folder / "cloud.ply", view.cloud)
        self.run_command("segment", "cloud.ply", "--no-table", "-o", "by_command")
        result = symscene.segment(view.cloud.points, view.cloud.normals, table=False)
        symscene.write_result(self.folder / "by_python", result)
        self.assert_same_files(self.folder / "by_command", self.folder / "by_python")

    def test_of_a_scene_is_what_the_command_finds_in_its_folder(self):
        symscene.write_scene(self.folder / "scene", example_result().scene)
        self.run_command("segment", "scene", "-o", "by_command")
        scene = symscene.read_scene(self.folder / "scene")
        symscene.write_result(self.folder / "by_python", symscene.segment(scene))
        self.assert_same_files(
            self.folder / "by_command", self.folder / "by_python", leave_out={"surface.ply"}
        )

    def test_of_points_with_their_table_and_occupancy_is_that_of_their_scene(self):
        scene = example_result().scene
        result = symscene.segment(
            scene.cloud.points, scene.cloud.normals, scene.occupancy, scene.table
        )
        np.testing.assert_array_equal(result.points, example_result().points)
        for one, other in zip(result.objects, example_result().objects):
            np.testing.assert_array_equal(one.indices, other.indices)

    def test_result_is_read_back(self):
        symscene.write_result(self.folder / "result", example_result())
        read = symscene.read_result(self.folder / "result")
        symscene.write_result(self.folder / "again", read)
        self.assertEqual(
            objects_without_times(self.folder / "result"),
            objects_without_times(self.folder / "again"),
        )
        for one, other in zip(read.objects, example_result().objects):
            np.testing.assert_array_equal(one.indices, other.indices)
            # OBJ files have another order of vertices and triangles.
            self.assertEqual(one.mesh.triangles.shape, other.mesh.triangles.shape)
            corners = [np.sort(item.mesh.vertices, axis=0) for item in (one, other)]
            np.testing.assert_allclose(*corners, atol=1e-5)


if __name__ == "__main__":
    unittest.main()
