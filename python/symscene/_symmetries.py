"""Symmetries of models and of partial scans, and the hidden side that they imply."""

from __future__ import annotations

from typing import Any, Iterable, List, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _symscene
from ._options import Options, options_json
from ._symscene import (
    ObjectAxis,
    ObjectPlane,
    ObjectSymmetries,
    Occupancy,
    PointCloud,
    SceneObject,
    SymmetryGroup,
    TriangleMesh,
)


def _cloud(points: Union[ArrayLike, PointCloud], normals: Optional[ArrayLike]) -> PointCloud:
    if not isinstance(points, PointCloud):
        return PointCloud(points, normals)
    if normals is not None:
        _symscene.refuse("normals", "none beside a PointCloud, which has its own", "one")
    return points


def symmetries(
    model: Union[TriangleMesh, PointCloud, ArrayLike],
    normals: Optional[ArrayLike] = None,
    *,
    options: Options = None,
    threads: int = 0,
    **keywords: Any,
) -> SymmetryGroup:
    """Find the symmetry group of a whole model, as `symscene symmetry` does.

    model: a TriangleMesh, or points of all its sides: a PointCloud or (N, 3). Any unit.
    normals: (N, 3) unit vectors out of the surface; estimated where there are none.
    options, keywords: options of `symscene symmetry` (default_options("symmetries")).
    threads: most threads; 0: all cores. The result does not depend on it.
    """
    text = options_json(options, keywords)
    if isinstance(model, TriangleMesh):
        return _symscene.mesh_symmetries(model, text, threads)
    return _symscene.cloud_symmetries(_cloud(model, normals), text, threads)


def partial_symmetries(
    points: Union[TriangleMesh, PointCloud, ArrayLike],
    normals: Optional[ArrayLike] = None,
    *,
    options: Options = None,
    threads: int = 0,
    **keywords: Any,
) -> ObjectSymmetries:
    """Find the probable axis and mirror planes of a partial scan of one object, of any scale.

    points: a PointCloud, (N, 3), or a TriangleMesh. Any unit.
    normals: (N, 3) unit vectors out of the surface; estimated where there are none.
    options, keywords: options of `symscene symmetry --partial`
        (default_options("partial_symmetries")).
    threads: most threads; 0: all cores. The result does not depend on it.
    """
    if isinstance(points, TriangleMesh):
        points = _symscene.sampled_surface(points)
    return _symscene.partial_symmetries(
        _cloud(points, normals), options_json(options, keywords), threads
    )


def _axis_rows(axes: Iterable[Union[ObjectAxis, ArrayLike]]) -> List[ArrayLike]:
    return [
        np.concatenate([a.point, a.direction]) if isinstance(a, ObjectAxis) else np.ravel(a)
        for a in axes
    ]


def _plane_rows(planes: Iterable[Union[ObjectPlane, ArrayLike]]) -> List[ArrayLike]:
    return [
        np.concatenate([p.point, p.normal]) if isinstance(p, ObjectPlane) else np.ravel(p)
        for p in planes
    ]


def complete(
    points: Union[ArrayLike, PointCloud],
    normals: Optional[ArrayLike] = None,
    *,
    axes: Iterable[Union[ObjectAxis, ArrayLike]] = (),
    planes: Iterable[Union[ObjectPlane, ArrayLike]] = (),
    occupancy: Optional[Occupancy] = None,
    table: Optional[ArrayLike] = None,
    options: Options = None,
    threads: int = 0,
    **keywords: Any,
) -> SceneObject:
    """Complete an observed object by its symmetries: its hidden points and its closed surface.

    points: (N, 3) in metres or a PointCloud: the observed points of one object.
    normals: (N, 3) unit vectors out of the surface; estimated where there are none.
    axes, planes: its symmetries, the best first: ObjectAxis and ObjectPlane, or (2, 3) arrays of a
        point and a direction or normal. Without any the surface ends at the visible hull.
    occupancy: free space, into which the surface does not reach.
    table: (a, b, c, d) of the plane ax + by + cz + d = 0 on which the object stands [m].
    options, keywords: options of `symscene segment` (default_options("segment")); `completion` and
        `object_surface` decide.
    threads: most threads; 0: all cores. The result does not depend on it.

    The object's `completed` are the added points, `mesh` is the closed surface, `solid` its volume
    and centre of mass.
    """
    return _symscene.complete(
        _cloud(points, normals),
        _axis_rows(axes),
        _plane_rows(planes),
        occupancy,
        table,
        options_json(options, keywords),
        threads,
    )
