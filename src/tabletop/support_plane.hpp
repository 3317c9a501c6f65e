#pragma once

#include "symscene/tabletop/table_scene.hpp"

namespace symscene {

/// Finds the planes that objects stand on by RANSAC on the positions and normals of a sample of the
/// points, one plane after the other, each refined by least squares on all points of its largest
/// connected patch. Supports are extended to all patches of their plane, which shadows separate.
/// Where up is known (gravity, or the mean of the cameras' −y axes) only planes that face it are
/// supports, and with a lower score those that face the cameras. Throws InputError if points have
/// no normals.
SupportPlanes find_support_planes(const PointCloud& cloud, const SupportPlaneOptions& options = {},
                                  const TablePrior& known = {});

/// The inliers, areas and outline of a given plane, which keeps its position; its normal is
/// normalised. The outline is empty without inliers. Throws InputError if the normal is zero or the
/// plane not finite.
SupportPlane measure_support_plane(const PointCloud& cloud, const Plane& plane,
                                   const SupportPlaneOptions& options = {});

}  // namespace symscene
