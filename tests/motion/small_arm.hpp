#pragma once

#include <string>

#include "core/random.hpp"
#include "symscene/core/types.hpp"
#include "symscene/grasping/planner.hpp"
#include "symscene/robots/robot.hpp"

namespace symscene::testing {

inline Eigen::Isometry3d shifted(double x, double y, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

/// A link that a revolute joint carries, its capsule from the joint along the link's z axis.
inline void add_turning_link(RobotModel& model, const Eigen::Isometry3d& T_parent_joint,
                             const Eigen::Vector3d& axis, double length, double radius) {
  Joint joint;
  joint.name = "joint" + std::to_string(model.joints.size() + 1);
  joint.kind = JointKind::revolute;
  joint.parent = model.links.size() - 1;
  joint.child = model.links.size();
  joint.T_parent_joint = T_parent_joint;
  joint.axis = axis;
  joint.limits = {-radians(170.0), radians(170.0), 2.0, 8.0};
  joint.position = model.moving_joints();
  model.joints.push_back(joint);
  const Capsule capsule{{0.0, 0.0, 0.0}, {0.0, 0.0, length}, radius};
  model.links.push_back({"link" + std::to_string(model.links.size()),
                         length > 0.0 ? std::vector<Capsule>{capsule} : std::vector<Capsule>{}});
}

/// Six turning joints as of common industrial arms: an upper arm of 0.4 m, a forearm of 0.35 m and
/// a wrist of three axes. Its base stands at the origin.
inline Robot small_arm() {
  Robot robot;
  RobotModel& model = robot.model;
  model.name = "small arm";
  model.links.push_back({"base", {}});
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  add_turning_link(model, shifted(0.0, 0.0, 0.0), z, 0.3, 0.06);
  add_turning_link(model, shifted(0.0, 0.0, 0.3), y, 0.4, 0.05);
  add_turning_link(model, shifted(0.0, 0.0, 0.4), y, 0.35, 0.04);
  add_turning_link(model, shifted(0.0, 0.0, 0.35), z, 0.0, 0.0);
  add_turning_link(model, shifted(0.0, 0.0, 0.0), y, 0.1, 0.04);
  add_turning_link(model, shifted(0.0, 0.0, 0.1), z, 0.0, 0.0);
  model.ignored_pairs = {{3, 5}};  // both begin in the middle of the wrist
  robot.arms.push_back(
      {make_arm(model, "arm", "base", "link6"), "panda", Eigen::Isometry3d::Identity()});
  robot.home = Eigen::VectorXd::Zero(6);
  robot.home << 0.0, -0.4, 1.8, 0.0, 1.0, 0.0;
  return robot;
}

inline Gripper small_gripper() {
  Gripper gripper;
  gripper.name = "small";
  gripper.T_wrist_tool = shifted(0.0, 0.0, 0.1);
  return gripper;
}

/// Points of a box's faces, 5 mm apart, as an object that was seen from everywhere.
inline GraspObject box_of_points(const Eigen::Vector3d& size, const Eigen::Vector3d& centre) {
  std::vector<Eigen::Vector3d> points;
  const Eigen::Array3i steps = (size.array() / 0.005).ceil().cast<int>();
  for (int i = 0; i <= steps.x(); ++i) {
    for (int j = 0; j <= steps.y(); ++j) {
      for (int k = 0; k <= steps.z(); ++k) {
        const Eigen::Array3i at(i, j, k);
        if ((at != 0 && at != steps).all()) continue;
        points.emplace_back(centre.array() +
                            size.array() * (at.cast<double>() / steps.cast<double>() - 0.5));
      }
    }
  }
  GraspObject object;
  object.observed.positions.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    object.observed.positions.row(static_cast<Eigen::Index>(i)) = points[i].cast<float>();
  return object;
}

inline Eigen::VectorXd random_positions(const Robot& robot, Random& random) {
  Eigen::VectorXd positions(static_cast<Eigen::Index>(robot.model.moving_joints()));
  for (Eigen::Index i = 0; i < positions.size(); ++i) {
    const JointLimits& limits =
        robot.model.joints[robot.model.joint_of_position(static_cast<std::size_t>(i))].limits;
    positions[i] = random.uniform(limits.lower, limits.upper);
  }
  return positions;
}

}  // namespace symscene::testing
