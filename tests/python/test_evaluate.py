"""Objects that are found, compared with ground truth, as the command does it."""

import json
import os
import unittest
import warnings

import numpy as np

import symscene
from support import COMMAND, FolderTest, example_result

TIMES = ("timings", "runtimes", "seconds", "date", "made_with")


def without_times(value):
    if isinstance(value, dict):
        return {k: without_times(v) for k, v in value.items() if k not in TIMES}
    if isinstance(value, list):
        return [without_times(v) for v in value]
    return value


class Evaluate(FolderTest):
    """A dataset of one small scene, a ball whose points are all of one object."""

    def setUp(self):
        super().setUp()
        ball = min(example_result().objects, key=lambda item: len(item.points))
        scene = self.folder / "dataset" / "ball"
        scene.mkdir(parents=True)
        symscene.write_cloud(scene / "cloud.ply", symscene.PointCloud(ball.points, ball.normals))
        centroid = [float(v) for v in np.mean(ball.points, axis=0)]
        item = {
            "name": "ball", "points": list(range(len(ball.points))), "rot": [], "refl": [],
            "sphere": True, "centroid": centroid,
        }
        truth = {"table": [float(v) for v in example_result().table], "objects": [item]}
        (scene / "truth.json").write_text(json.dumps(truth))

    def evaluate(self, **keywords):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # that table and occupancy are missing
            return self.evaluated(**keywords)

    def evaluated(self, **keywords):
        return symscene.evaluate(self.folder / "dataset", fast=True, voxel_size=0.008, **keywords)

    def test_gives_the_report_of_the_command(self):
        if not COMMAND:
            self.skipTest("the command is not built")
        options = self.folder / "options.json"
        options.write_text('{"voxel_size": 0.008}')
        self.run_command("evaluate", "dataset", "-o", "report", "--baselines", "none", "--fast",
                         "--config", options)
        told = json.loads((self.folder / "report" / "report.json").read_text())
        self.assertEqual(without_times(told), without_times(self.evaluate()))

    def test_tells_scene_and_stage(self):
        told = []
        report = self.evaluate(progress=told.append, threads=1)
        self.assertEqual(told[0], "scene 1 of 1, ball: read")
        self.assertEqual(len(report["scenes"]), 1)

    def test_warns_of_what_the_scenes_lack(self):
        with self.assertWarnsRegex(UserWarning, "scene ball: no occupancy map"):
            self.evaluated()

    def test_refuses_a_folder_without_ground_truth(self):
        os.remove(self.folder / "dataset" / "ball" / "truth.json")
        with self.assertRaisesRegex(symscene.InputError, "dataset"):
            self.evaluate()


if __name__ == "__main__":
    try:
        symscene.evaluate(os.devnull)
    except symscene.InputError as error:
        if "evaluation's wing" in str(error):
            raise SystemExit(f"Skipped: {error}") from None
    unittest.main()
