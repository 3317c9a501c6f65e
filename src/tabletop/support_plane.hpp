#pragma once

#include <optional>

#include "symscene/tabletop/table_scene.hpp"

namespace symscene {

/// Finds the planes that objects stand on by RANSAC on the positions and normals of a sample of the
/// points, one plane after the other, each refined by least squares on all points of its largest
/// connected patch. Where `up` is known (gravity, or the mean of the cameras' −y axes) only planes
/// that face it are supports. Throws InputError if points have no normals.
SupportPlanes find_support_planes(const PointCloud& cloud, const SupportPlaneOptions& options = {},
                                  const std::optional<Eigen::Vector3d>& up = std::nullopt);

/// The inliers, areas and outline of a given plane, which keeps its position; its normal is
/// normalised. The outline is empty without inliers. Throws InputError if the normal is zero or the
/// plane not finite.
SupportPlane measure_support_plane(const PointCloud& cloud, const Plane& plane,
                                   const SupportPlaneOptions& options = {});

}  // namespace symscene
