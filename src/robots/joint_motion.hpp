#pragma once

#include "symscene/robots/robot_model.hpp"

namespace symscene {

/// Pose of the child link in the parent link, at position q of the joint.
inline Eigen::Isometry3d T_parent_child(const Joint& joint, double q) {
  switch (joint.kind) {
    case JointKind::fixed:
      return joint.T_parent_joint;
    case JointKind::prismatic:
      return joint.T_parent_joint * Eigen::Translation3d(q * joint.axis);
    case JointKind::revolute:
    case JointKind::continuous:
      break;
  }
  return joint.T_parent_joint * Eigen::AngleAxisd(q, joint.axis);
}

}  // namespace symscene
