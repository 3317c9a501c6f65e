"""The symmetries of a partial scan, and the object that they complete."""

import numpy as np
import symscene

angle, height = np.meshgrid(np.linspace(-1.6, 1.6, 80), np.linspace(0.0, 0.12, 40))
normals = np.stack([np.cos(angle), np.sin(angle), np.zeros_like(angle)], axis=-1).reshape(-1, 3)
points = 0.04 * normals + np.stack([0 * angle, 0 * angle, height], axis=-1).reshape(-1, 3)

found = symscene.partial_symmetries(points, normals)
for axis in found.axes:
    print("axis through", axis.point.round(3), "along", axis.direction.round(3))
whole = symscene.complete(points, normals, axes=found.axes, table=(0, 0, 1, 0))
if whole.solid is not None:
    print(f"{1e6 * whole.solid.volume:.0f} ml of {1e6 * np.pi * 0.04**2 * 0.12:.0f} ml")
