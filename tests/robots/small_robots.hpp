#pragma once

#include <string>

#include "symscene/core/types.hpp"
#include "symscene/robots/robot_model.hpp"

namespace symscene {

/// Adds a link on a joint; angles up to ±170°.
inline void add_link(RobotModel& model, std::size_t parent, const Eigen::Isometry3d& T_parent_joint,
                     const Eigen::Vector3d& axis, JointKind kind = JointKind::revolute) {
  Joint joint;
  joint.name = "joint" + std::to_string(model.joints.size());
  joint.kind = kind;
  joint.parent = parent;
  joint.child = model.links.size();
  joint.T_parent_joint = T_parent_joint;
  joint.axis = axis.normalized();
  joint.limits = {-radians(170.0), radians(170.0), 1.0, 1.0};
  if (kind != JointKind::fixed) joint.position = model.moving_joints();
  model.joints.push_back(joint);
  model.links.push_back({"link" + std::to_string(model.links.size()), {}});
}

inline RobotModel single_link() {
  RobotModel model;
  model.name = "small";
  model.links.push_back({"link0", {}});
  return model;
}

/// Two parallel joints about z, then a tip: links of 0.3 m and 0.2 m along x.
inline RobotModel planar_arm() {
  RobotModel model = single_link();
  const auto along_x = [](double x) {
    return Eigen::Isometry3d(Eigen::Translation3d(x, 0.0, 0.0));
  };
  add_link(model, 0, along_x(0.0), Eigen::Vector3d::UnitZ());
  add_link(model, 1, along_x(0.3), Eigen::Vector3d::UnitZ());
  add_link(model, 2, along_x(0.2), Eigen::Vector3d::UnitZ(), JointKind::fixed);
  return model;
}

/// Seven joints as of a human arm: three in the shoulder, one elbow, three in the wrist, with
/// offsets, so that neither axes nor origins coincide everywhere. Its length is about 1 m.
inline RobotModel seven_joint_arm() {
  RobotModel model = single_link();
  const auto at = [](double x, double y, double z) {
    return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
  };
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
  add_link(model, 0, at(0.0, 0.0, 0.3), z);
  add_link(model, 1, at(0.05, 0.0, 0.0), y);
  add_link(model, 2, at(0.0, 0.0, 0.35), z);
  add_link(model, 3, at(0.06, 0.0, 0.0), y);
  add_link(model, 4, at(-0.06, 0.0, 0.3), z);
  add_link(model, 5, at(0.0, 0.02, 0.0), Eigen::Vector3d(0.1, 1.0, 0.0));
  add_link(model, 6, at(0.08, 0.0, 0.1), z);
  add_link(model, 7, at(0.0, 0.0, 0.1), z, JointKind::fixed);
  return model;
}

}  // namespace symscene
