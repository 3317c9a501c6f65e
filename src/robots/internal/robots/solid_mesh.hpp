#pragma once

#include <Eigen/Geometry>

#include "symscene/core/triangle_mesh.hpp"
#include "symscene/robots/robot_model.hpp"

namespace symscene {

/// The surface of an axis-aligned box. [m]
TriangleMesh box_mesh(const Eigen::AlignedBox3d& box);

/// The surface of a capsule, a sphere if both of its ends are one point. [m]
TriangleMesh capsule_mesh(const Capsule& capsule);

}  // namespace symscene
