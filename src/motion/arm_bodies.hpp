#pragma once

#include <string>
#include <vector>

#include "symscene/core/gripper.hpp"
#include "symscene/robots/robot.hpp"

namespace symscene {

/// A part of a robot that is rigid: a link, or the gripper.
struct ArmBody {
  std::string name;
  std::size_t link = 0;  ///< in whose frame the shapes are
  std::vector<Capsule> capsules;
  std::vector<Eigen::AlignedBox3d> boxes = {};  ///< of the gripper, in its tool frame
  bool moves = false;                           ///< with the arm
  bool can_meet_table = false;
  /// By how much the body's points move at most per unit of each joint of the arm. [m/rad]
  Eigen::VectorXd motion = {};
};

/// Two bodies that are tested for collision with each other.
struct BodyPair {
  std::size_t a = 0;
  std::size_t b = 0;
};

/// A robot's parts as an arm moves them.
struct ArmBodies {
  std::vector<ArmBody> bodies;
  std::vector<BodyPair> pairs;
  Eigen::Isometry3d T_tip_tool = Eigen::Isometry3d::Identity();
};

/// `up`: normal of the table in the base frame.
ArmBodies arm_bodies(const Robot& robot, const RobotArm& arm, const Gripper* gripper,
                     double opening, const Eigen::Vector3d& up);

/// The same bound for points within `extent` of the origin of a link. [m/rad]
Eigen::VectorXd greatest_motion(const RobotModel& model, const Arm& arm, std::size_t link,
                                double extent);

}  // namespace symscene
