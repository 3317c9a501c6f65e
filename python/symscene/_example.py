"""A simulated depth image, for first steps and tests."""

from __future__ import annotations

from typing import Callable, List, Tuple

import numpy as np
from numpy.typing import NDArray

from ._symscene import CameraIntrinsics

Floats = NDArray[np.float64]

_TILT = np.radians(40.0)  # of the camera below the horizon
_HEIGHT = 0.6  # of the camera above the table [m]
_NOISE = 1.425e-3  # standard deviation of a depth over its square [1/m]
_MIDDLE = np.array([0.0, 0.7])  # of the objects [m]


def _smaller(a: Floats, b: Floats) -> Floats:
    return np.where(np.isnan(a), b, np.where(np.isnan(b), a, np.minimum(a, b)))


def _plane(origin: Floats, rays: Floats) -> Floats:
    """Distances along rays of the table z = 0, a disk of 0.6 m radius."""
    t = -origin[2] / rays[..., 2]
    x = origin[0] + t * rays[..., 0]
    y = origin[1] + t * rays[..., 1] - 0.7
    return np.where((t > 0) & (np.hypot(x, y) < 0.6), t, np.nan)


def _sphere(origin: Floats, rays: Floats, center: Floats, radius: float) -> Floats:
    offset = origin - center
    a = np.sum(rays * rays, axis=-1)
    b = rays @ offset
    inside = b * b - a * (offset @ offset - radius * radius)
    t: Floats = (-b - np.sqrt(np.where(inside >= 0, inside, np.nan))) / a
    return t


def _cylinder(origin: Floats, rays: Floats, center: Floats, radius: float, height: float) -> Floats:
    offset = (origin - center)[:2]
    flat = rays[..., :2]
    a = np.sum(flat * flat, axis=-1)
    b = flat @ offset
    inside = b * b - a * (offset @ offset - radius * radius)
    side = (-b - np.sqrt(np.where(inside >= 0, inside, np.nan))) / a
    z = origin[2] + side * rays[..., 2]
    side = np.where((z >= 0) & (z <= height), side, np.nan)
    top = (height - origin[2]) / rays[..., 2]
    at_top = offset + top[..., None] * flat
    return _smaller(side, np.where(np.sum(at_top**2, axis=-1) <= radius**2, top, np.nan))


def _box(origin: Floats, rays: Floats, center: Floats, size: Floats, turn: float) -> Floats:
    c, s = np.cos(turn), np.sin(turn)
    axes = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
    start, step = axes @ (origin - center), rays @ axes.T
    low, high = (-size / 2 - start) / step, (size / 2 - start) / step
    near = np.minimum(low, high).max(axis=-1)
    far = np.maximum(low, high).min(axis=-1)
    return np.where((near <= far) & (near > 0), near, np.nan)


def _pose(angle: float) -> Floats:
    """T_world_camera of a camera that turned about the objects by an angle and looks at them."""
    c, s = np.cos(_TILT), np.sin(_TILT)
    T_world_camera = np.eye(4)
    T_world_camera[:3, :3] = [[1.0, 0.0, 0.0], [0.0, -s, c], [0.0, -c, -s]]
    T_world_camera[:3, 3] = [0.0, 0.0, _HEIGHT]
    c, s = np.cos(angle), np.sin(angle)
    turn = np.eye(4)
    turn[:2, :2] = [[c, -s], [s, c]]
    turn[:2, 3] = _MIDDLE - turn[:2, :2] @ _MIDDLE
    return turn @ T_world_camera


def _render(T_world_camera: Floats, camera: CameraIntrinsics, seed: int) -> NDArray[np.uint16]:
    u, v = np.meshgrid(np.arange(camera.width), np.arange(camera.height))
    rays_camera = np.stack(
        [(u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, np.ones(u.shape)], axis=-1
    )
    rays, origin = rays_camera @ T_world_camera[:3, :3].T, T_world_camera[:3, 3]
    surfaces: List[Callable[[Floats, Floats], Floats]] = [
        _plane,
        lambda o, r: _sphere(o, r, np.array([-0.17, 0.68, 0.05]), 0.05),
        lambda o, r: _box(o, r, np.array([0.02, 0.8, 0.06]), np.array([0.1, 0.07, 0.12]), 0.5),
        lambda o, r: _cylinder(o, r, np.array([0.18, 0.65, 0.0]), 0.04, 0.11),
    ]
    depth = np.full(u.shape, np.nan)
    with np.errstate(divide="ignore", invalid="ignore"):
        for surface in surfaces:
            depth = _smaller(depth, surface(origin, rays))
    noise = np.random.Generator(np.random.PCG64(seed)).standard_normal(depth.shape)
    depth += _NOISE * depth**2 * noise
    millimetres: NDArray[np.uint16] = np.nan_to_num(np.round(1000.0 * depth)).astype(np.uint16)
    return millimetres


def example_depth() -> Tuple[NDArray[np.uint16], CameraIntrinsics]:
    """A depth image, (480, 640) uint16 in millimetres, of a ball, a box and a cylinder on a table.

    It is simulated with the noise of a structured-light camera, the same at every call.
    """
    camera = CameraIntrinsics(640, 480, 525.0, 525.0, 319.5, 239.5)
    return _render(_pose(0.0), camera, 1), camera


def example_sweep(
    count: int = 12,
) -> Tuple[List[NDArray[np.uint16]], List[Floats], CameraIntrinsics]:
    """Depth images of the same table by a camera that turns about the objects by 3 degrees per frame.

    They come with T_world_camera of each, (4, 4) in metres, and the camera.
    """
    camera = CameraIntrinsics(640, 480, 525.0, 525.0, 319.5, 239.5)
    poses = [_pose(np.radians(3.0) * k) for k in range(count)]
    return [_render(pose, camera, 1 + k) for k, pose in enumerate(poses)], poses, camera
