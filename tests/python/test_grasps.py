"""Grasps are those that the command plans."""

import json
import unittest

import numpy as np

import symscene
from support import FolderTest, example_result


class Grasps(FolderTest):
    def test_approach_objects_with_a_rigid_pose(self):
        plan = symscene.grasps(example_result())
        self.assertEqual(plan.gripper, "panda")
        self.assertEqual(len(plan.reasons), len(example_result().objects))
        self.assertTrue(plan.grasps)
        for grasp in plan.grasps:
            R = grasp.T_world_tool[:3, :3]
            np.testing.assert_allclose(R @ R.T, np.eye(3), atol=1e-9)
            self.assertLess(grasp.object, len(example_result().objects))
            self.assertLessEqual(grasp.opening, 0.08)
        qualities = [grasp.quality for grasp in plan.grasps]
        self.assertEqual(qualities, sorted(qualities, reverse=True))

    def test_of_a_result_and_its_scene_are_those_of_the_command(self):
        symscene.write_scene(self.folder / "scene", example_result().scene)
        symscene.write_result(self.folder / "result", example_result())
        self.run_command("grasp", "result", "--scene", "scene", "-o", "by_command.json")
        result = symscene.read_result(self.folder / "result")
        plan = symscene.grasps(result, scene=symscene.read_scene(self.folder / "scene"))
        symscene.write_grasps(self.folder / "by_python.json", plan)
        told = [json.loads((self.folder / f"by_{who}.json").read_text())
                for who in ("command", "python")]
        for grasps in told:
            grasps.pop("timings", None)
        self.assertEqual(*told)
        read = symscene.read_grasps(self.folder / "by_command.json")
        self.assertEqual(len(read.grasps), len(plan.grasps))

    def test_for_an_unknown_gripper_are_refused(self):
        with self.assertRaisesRegex(symscene.InputError, "gripper: expected .*panda"):
            symscene.grasps(example_result(), "tongs")


if __name__ == "__main__":
    unittest.main()
