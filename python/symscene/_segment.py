"""Objects of clouds, scenes and depth images."""

from __future__ import annotations

from typing import Any, Optional, Union

from numpy.typing import ArrayLike

from . import _symscene
from ._options import Options, Progress, options_json
from ._symscene import (
    CameraIntrinsics,
    Occupancy,
    PointCloud,
    Scene,
    SegmentationResult,
)

Intrinsics = Union[CameraIntrinsics, ArrayLike]
"""CameraIntrinsics, (fx, fy, cx, cy) in pixels, or a matrix [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]."""

Table = Union[ArrayLike, bool, None]
"""None: the table is searched. False: there is none. (a, b, c, d): the plane ax + by + cz + d = 0."""


def segment_depth(
    depth: ArrayLike,
    intrinsics: Intrinsics,
    *,
    depth_scale: Optional[float] = None,
    color: Optional[ArrayLike] = None,
    table: Table = None,
    any_up: bool = False,
    sensor: Optional[str] = None,
    options: Options = None,
    progress: Progress = None,
    threads: int = 0,
    **keywords: Any,
) -> SegmentationResult:
    """Find the objects of a single depth image.

    depth: (height, width). Integers are millimetres unless depth_scale says otherwise, floats are
        metres, along the optical axis; 0, NaN and infinity mean not measured.
    intrinsics: CameraIntrinsics, (fx, fy, cx, cy) in pixels, or a 3x3 matrix.
    depth_scale: value of the image that is 1 m.
    color: (height, width, 3) uint8 of the same pixels.
    table: None: it is searched. False: there is none, and all that is seen is taken.
        (a, b, c, d): its plane, in the camera's frame [m].
    any_up: the camera was not held upright: accept a table of any orientation.
    sensor: "structured-light", "stereo" or "tof"; by default the image tells.
    options, keywords: options of `symscene segment`, in groups (default_options("segment")).
    progress: is called with the name of each stage when it begins.
    threads: most threads; 0: all cores. The result does not depend on it.

    The result is in the camera's frame, in metres: x to the right, y down, z forwards. Its
    label_image tells the object of each pixel. Raises InputError, with the command's sentence.
    """
    return _symscene.segment_depth(
        depth,
        intrinsics,
        depth_scale,
        color,
        table,
        any_up,
        sensor,
        options_json(options, keywords),
        progress,
        threads,
    )


def segment(
    points: Union[ArrayLike, PointCloud, Scene],
    normals: Optional[ArrayLike] = None,
    occupancy: Optional[Occupancy] = None,
    table: Table = None,
    *,
    colors: Optional[ArrayLike] = None,
    viewpoint: Optional[ArrayLike] = None,
    any_up: bool = False,
    options: Options = None,
    progress: Progress = None,
    threads: int = 0,
    **keywords: Any,
) -> SegmentationResult:
    """Find the objects of a cloud or a scene.

    points: (N, 3) in metres, a PointCloud, or a Scene. A scene is segmented as it is. Of points,
        those of the table are taken out first, if there is one.
    normals: (N, 3) unit vectors out of the surface; estimated where there are none.
    occupancy: which space is free, occupied or never seen; without it, all space off the surface
        counts as never seen.
    table: None: it is searched. False: there is none, and all points are taken.
        (a, b, c, d): its plane; points on it, if there are any, are taken out.
    colors: (N, 3) uint8.
    viewpoint: (3,) position of the sensor, if the points are a single view [m].
    any_up: z need not point up: accept a table of any orientation.
    options, keywords: options of `symscene segment`, in groups (default_options("segment")).
    progress: is called with the name of each stage when it begins.
    threads: most threads; 0: all cores. The result does not depend on it.

    The result is in the frame of the points. Raises InputError, with the command's sentence.
    """
    text = options_json(options, keywords)
    if isinstance(points, (Scene, PointCloud)):
        given: dict[str, object] = {"normals": normals, "colors": colors, "viewpoint": viewpoint}
        if isinstance(points, Scene):
            given.update(occupancy=occupancy, table=table, any_up=any_up or None)
        for name, value in given.items():
            if value is not None:
                kind = type(points).__name__
                _symscene.refuse(name, f"none beside a {kind}, which has its own", "one")
    if isinstance(points, Scene):
        return _symscene.segment_scene(points, text, progress, threads)
    if not isinstance(points, PointCloud):
        points = PointCloud(points, normals, colors, viewpoint)
    return _symscene.segment_cloud(points, occupancy, table, any_up, text, progress, threads)
