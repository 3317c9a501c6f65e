"""Scenes from depth frames of a moving camera."""

from __future__ import annotations

import itertools
import warnings
from typing import Any, Iterable, Iterator, List, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _symscene
from ._options import Options, Progress, default_options, options_json
from ._segment import Intrinsics, Table
from ._symscene import DepthSequence, Frame, FrameReport, InputError, Scene, TriangleMesh

FrameLike = Union[Frame, ArrayLike, Tuple[ArrayLike, ArrayLike]]
"""A Frame, a depth image, or a depth image and a colour image."""


def _frame(given: FrameLike, pose: Optional[ArrayLike], depth_scale: Optional[float]) -> Frame:
    if isinstance(given, Frame):
        if pose is None:
            return given
        return Frame(given.depth, given.color, pose, given.time)
    if isinstance(given, tuple):
        if len(given) != 2:
            _symscene.refuse("frame", "a pair of depth and colour image", f"{len(given)} values")
        return Frame(given[0], given[1], pose, 0.0, depth_scale)
    return Frame(given, None, pose, 0.0, depth_scale)


class Reconstruction:
    """A scene that grows with each depth frame.

        reconstruction = symscene.Reconstruction(intrinsics)
        for depth in camera:
            report = reconstruction.add(depth)
        scene = reconstruction.scene()

    The first frame that measures enough defines the world: its camera is at the origin unless it
    has a pose. Threads may share a reconstruction.
    """

    def __init__(
        self,
        intrinsics: Intrinsics,
        *,
        depth_scale: Optional[float] = None,
        sensor: Optional[str] = None,
        options: Options = None,
        threads: int = 0,
        **keywords: Any,
    ) -> None:
        """intrinsics: CameraIntrinsics, (fx, fy, cx, cy) in pixels, or a 3x3 matrix.

        depth_scale: value of depth images that is 1 m; without it integers are millimetres, floats
            metres.
        sensor: "structured-light", "stereo" or "tof"; by default the first frame tells.
        options, keywords: options of `symscene reconstruct` (default_options("reconstruct")).
        threads: most threads; 0: all cores. The result does not depend on it.
        """
        self._depth_scale = depth_scale
        self._tracked = _symscene.TrackedScene(
            intrinsics, sensor, options_json(options, keywords), threads
        )

    def look_at(self, frames: Iterable[FrameLike], is_tracked: bool = True) -> None:
        """Tell the sensor by frames that are spread over the sweep, before the first is added."""
        self._tracked.look_at([_frame(f, None, self._depth_scale) for f in frames], is_tracked)

    def add(
        self,
        frame: FrameLike,
        T_world_camera: Optional[ArrayLike] = None,
        pose_use: str = "exact",
    ) -> FrameReport:
        """Locate a frame and fuse it.

        frame: a depth image (height, width), a pair with its colours, or a Frame.
        T_world_camera: (4, 4) pose of the camera, if it is known [m].
        pose_use: how it is used: "exact", "start" (tracking starts from it) or "prior" (it is known
            up to tracking.prior_deviation).
        """
        return self._tracked.add(_frame(frame, T_world_camera, self._depth_scale), pose_use)

    def scene(self, table: Table = None, any_up: bool = False) -> Scene:
        """The scene of the frames so far, with its mesh.

        table: None: it is searched; False: there is none; (a, b, c, d): its plane.
        any_up: the camera was not held upright: accept a table of any orientation.
        """
        return self._tracked.scene(table, any_up)

    def mesh(self) -> TriangleMesh:
        """The surface of the frames so far."""
        return self._tracked.surface()

    @property
    def T_world_cameras(self) -> NDArray[np.float64]:
        """(N, 4, 4) poses of the fused frames [m]."""
        return self._tracked.T_world_cameras


def _readable(sequence: DepthSequence) -> Iterator[Frame]:
    for i in range(len(sequence)):
        try:
            yield sequence[i]
        except InputError as error:
            warnings.warn(f"{error}; the frame is left out", stacklevel=3)


def _first_and_all(
    frames: Iterable[FrameLike], count: int
) -> Tuple[List[FrameLike], bool, Iterator[FrameLike]]:
    """Frames that tell the sensor, whether there are several frames, and all of them in order."""
    if isinstance(frames, DepthSequence):
        return list(frames.spread_frames(count)), len(frames) > 1, _readable(frames)
    rest = iter(frames)
    first = list(itertools.islice(rest, max(count, 2)))
    return first[:count], len(first) > 1, itertools.chain(first, rest)


def _with_poses(
    frames: Iterable[FrameLike],
    poses: Optional[Iterable[Optional[ArrayLike]]],
    takes_own: bool,
) -> Iterator[Tuple[FrameLike, Optional[ArrayLike]]]:
    """Each frame without its pose, and the pose to use: of `poses`, else its own if `takes_own`."""
    known = iter(poses) if poses is not None else itertools.repeat(None)
    for frame in frames:
        pose = next(known, None)
        if isinstance(frame, Frame):
            if pose is None and takes_own:
                pose = frame.T_world_camera
            frame = Frame(frame.depth, frame.color, None, frame.time)
        yield frame, pose


def reconstruct(
    frames: Union[DepthSequence, Iterable[FrameLike]],
    intrinsics: Optional[Intrinsics] = None,
    *,
    poses: Optional[Iterable[Optional[ArrayLike]]] = None,
    pose_use: Optional[str] = None,
    depth_scale: Optional[float] = None,
    table: Table = None,
    any_up: bool = False,
    sensor: Optional[str] = None,
    options: Options = None,
    progress: Progress = None,
    threads: int = 0,
    **keywords: Any,
) -> Scene:
    """Turn depth frames of a moving camera into a scene: track, fuse, find the table.

    frames: a DepthSequence (open_sequence()), or anything that gives depth images, pairs of depth
        and colour images, or Frames. They are taken one after the other and not kept.
    intrinsics: CameraIntrinsics, (fx, fy, cx, cy) in pixels, or a 3x3 matrix; a sequence has its own.
    poses: T_world_camera of each frame, (4, 4) or None, if they are known [m].
    pose_use: "exact", "start" (tracking starts from them) or "prior"; of a sequence or of Frames
        poses are used only if this is given. With `poses` it is "exact" by default.
    depth_scale: value of depth images that is 1 m; without it integers are millimetres, floats metres.
    table: None: it is searched; False: there is none; (a, b, c, d): its plane.
    any_up: the camera was not held upright: accept a table of any orientation.
    sensor: "structured-light", "stereo" or "tof"; by default the frames tell: of a sequence frames
        that are spread over it, otherwise the first ones.
    options, keywords: options of `symscene reconstruct` (default_options("reconstruct")).
    progress: is called with "frame 1", "frame 2" ...
    threads: most threads; 0: all cores. The result does not depend on it.

    Frames that cannot be tracked are left out, and a warning of the scene counts them. They are not
    stitched as `symscene reconstruct` does with few frames that are far apart.
    """
    if intrinsics is None:
        if not isinstance(frames, DepthSequence):
            _symscene.refuse("intrinsics", "those of the camera", "None")
        intrinsics = frames.camera
    reconstruction = Reconstruction(
        intrinsics,
        depth_scale=depth_scale,
        sensor=sensor,
        options=options,
        threads=threads,
        **keywords,
    )
    merged: Any = {**(options or {}), **keywords}.get("sensor", {})
    count = merged.get("frames", default_options("reconstruct")["sensor"]["frames"])
    seen, is_tracked, all_frames = _first_and_all(frames, count)
    reconstruction.look_at(seen, is_tracked)
    needs_pose = poses is not None or pose_use is not None
    posed = _with_poses(all_frames, poses, takes_own=pose_use is not None)
    is_fused = False
    for number, (frame, pose) in enumerate(posed, start=1):
        if progress is not None:
            progress(f"frame {number}")
        if needs_pose and pose is None and not is_fused:
            continue  # the first fused frame sets the world frame, which must be that of the poses
        is_fused |= reconstruction.add(frame, pose, pose_use or "exact").fused
    if progress is not None:
        progress("find table")
    return reconstruction.scene(table, any_up)
