"""Grasps of the objects of a result."""

from __future__ import annotations

import os
from typing import Any, Optional, Union

from . import _symscene
from ._options import Options, options_json
from ._symscene import GraspPlan, Scene, SegmentationResult


def grasps(
    result: SegmentationResult,
    gripper: Union[str, "os.PathLike[str]"] = "panda",
    scene: Optional[Scene] = None,
    *,
    options: Options = None,
    threads: int = 0,
    **keywords: Any,
) -> GraspPlan:
    """Find grasps of the objects of a result, as `symscene grasp` does.

    gripper: "panda", "baxter", "reflex", or the path of a JSON or YAML file that describes one.
    scene: what was segmented; by default the result's own. Space that it never saw counts as
        occupied; without a scene or its occupancy all space off the objects is free.
    options, keywords: options of `symscene grasp` (default_options("grasps")).
    threads: most threads; 0: all cores. The result does not depend on it.
    """
    return _symscene.plan_grasps(
        result, os.fspath(gripper), scene, options_json(options, keywords), threads
    )
