#pragma once

#include <Eigen/Geometry>

#include "symscene/core/geometry.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// Moved by a rigid motion, normals with it.
PointCloud transformed(PointCloud cloud, const Eigen::Isometry3d& motion);
TriangleMesh transformed(TriangleMesh mesh, const Eigen::Isometry3d& motion);
Plane transformed(const Plane& plane, const Eigen::Isometry3d& motion);

}  // namespace symscene
