"""Objects on cluttered tables, found by their symmetries.

    import symscene

    depth, intrinsics = symscene.example_depth()  # or those of a camera
    result = symscene.segment_depth(depth, intrinsics)
    for item in result.objects:
        print(item.score, item.symmetry_class, item.points.shape, item.mesh)

Lengths are in metres, angles in radians, poses are T_world_camera as (4, 4) arrays. Arrays of
results are read-only views of the library's memory, without a copy. Functions release the GIL.
Invalid input raises InputError, a ValueError whose message is the sentence that the command prints.
"""

from ._example import example_depth, example_sweep
from ._evaluate import evaluate
from ._options import OptionDescription, default_options, describe_options
from ._grasps import grasps
from ._reconstruct import Reconstruction, reconstruct
from ._segment import segment, segment_depth
from ._symmetries import complete, partial_symmetries, symmetries
from ._symscene import (
    CameraIntrinsics,
    DepthSequence,
    Dimension,
    Frame,
    FrameReport,
    Grasp,
    GraspPlan,
    GroupAxis,
    GroupPlane,
    InputError,
    ObjectAxis,
    ObjectBox,
    ObjectClass,
    ObjectPlane,
    ObjectSymmetries,
    Occupancy,
    PointCloud,
    Rejection,
    Scene,
    SceneObject,
    SegmentationResult,
    SequenceWriter,
    SolidProperties,
    SymmetryGroup,
    TriangleMesh,
    __version__,
    open_sequence,
    read_cloud,
    read_grasps,
    read_mesh,
    read_occupancy,
    read_result,
    read_scene,
    write_cloud,
    write_grasps,
    write_mesh,
    write_result,
    write_scene,
)

__all__ = [
    "CameraIntrinsics",
    "DepthSequence",
    "Dimension",
    "Frame",
    "FrameReport",
    "Grasp",
    "GraspPlan",
    "GroupAxis",
    "GroupPlane",
    "InputError",
    "ObjectAxis",
    "ObjectBox",
    "ObjectClass",
    "ObjectPlane",
    "ObjectSymmetries",
    "Occupancy",
    "OptionDescription",
    "PointCloud",
    "Reconstruction",
    "Rejection",
    "Scene",
    "SceneObject",
    "SegmentationResult",
    "SequenceWriter",
    "SolidProperties",
    "SymmetryGroup",
    "TriangleMesh",
    "__version__",
    "complete",
    "default_options",
    "describe_options",
    "evaluate",
    "example_depth",
    "example_sweep",
    "grasps",
    "open_sequence",
    "partial_symmetries",
    "read_cloud",
    "read_grasps",
    "read_mesh",
    "read_occupancy",
    "read_result",
    "read_scene",
    "reconstruct",
    "segment",
    "segment_depth",
    "symmetries",
    "write_cloud",
    "write_grasps",
    "write_mesh",
    "write_result",
    "write_scene",
]
