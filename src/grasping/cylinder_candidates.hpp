#pragma once

#include <vector>

#include "symscene/grasping/bounding_cylinders.hpp"

namespace symscene {

/// A pose of the gripper around a cylinder.
struct CylinderCandidate {
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
  double offset = 0.0;  ///< along the axis from the cylinder's middle to that of the pads [m]
  double reach = 0.0;   ///< how far the finger tips pass the axis or the nearer cap [m]
};

/// Poses that envelop the cylinder: from the side the fingers pass the axis, up to the far side if
/// they are long enough; along the axis they hold it at both ends of a diameter (section 4.6.3).
std::vector<CylinderCandidate> cylinder_candidates(const BoundingCylinder& cylinder,
                                                   const Gripper& gripper,
                                                   const CylinderGraspOptions& options);

}  // namespace symscene
