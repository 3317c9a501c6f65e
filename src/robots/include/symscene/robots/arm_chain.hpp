#pragma once

#include <vector>

#include "symscene/robots/robot_model.hpp"

namespace symscene {

/// A moving joint of a chain; it turns about, or slides along, the z axis of its frame.
struct ChainJoint {
  /// From the moved frame of the joint before it, or from the base link.
  Eigen::Isometry3d T_previous_joint = Eigen::Isometry3d::Identity();
  JointKind kind = JointKind::revolute;
  double lower = 0.0;  ///< [rad or m]
  double upper = 0.0;
};

/// An arm without its fixed joints, for kinematics. Positions are those of the arm's moving joints,
/// in order, and poses are in the arm's base link.
struct ArmChain {
  std::vector<ChainJoint> joints;
  Eigen::Isometry3d T_last_tip = Eigen::Isometry3d::Identity();

  /// Distance that the tip can never exceed from the origin of the first joint: the sum of the
  /// distances between joints, and the travel of those that slide. [m]
  double length() const;
  /// Distance of a point in the base link from the origin of the first joint. [m]
  double distance_to(const Eigen::Vector3d& point_base) const;
};

/// The arm as a chain. Throws InputError if a limit of position is not finite, or the arm has more
/// than 16 moving joints.
ArmChain arm_chain(const RobotModel& model, const Arm& arm);

/// T_base_tip. Throws InputError unless there is one finite position per joint.
Eigen::Isometry3d tip_pose(const ArmChain& chain, const Eigen::VectorXd& positions);

/// The geometric Jacobian of the tip, 6×N: rows are angular velocity and velocity of the tip's
/// origin, in the base link's frame, per unit of joint velocity. Throws as tip_pose().
Eigen::Matrix<double, 6, Eigen::Dynamic> tip_jacobian(const ArmChain& chain,
                                                      const Eigen::VectorXd& positions);

}  // namespace symscene
