// Whether an arm reaches a pose, and why not.
#include <algorithm>

#include "symscene/robots/reachability.hpp"

namespace symscene {
namespace {

/// How far a position is beyond the limits; negative inside.
double excess(const JointLimits& limits, double position) {
  return std::max(limits.lower - position, position - limits.upper);
}

Reach rejected(ReachRejection reason, double value, double bound) {
  Reach reach;
  reach.reason = reason;
  reach.value = value;
  reach.bound = bound;
  return reach;
}

Reach beyond_limits(const RobotModel& model, const Arm& arm, const Eigen::VectorXd& positions) {
  Reach reach = rejected(ReachRejection::joint_limit, 0.0, 0.0);
  double most = 0.0;
  for (std::size_t i = 0; i < arm.positions.size(); ++i) {
    const std::size_t index = model.joint_of_position(arm.positions[i]);
    const JointLimits& limits = model.joints[index].limits;
    const double position = positions[static_cast<Eigen::Index>(i)];
    if (!(excess(limits, position) > most)) continue;
    most = excess(limits, position);
    reach.joint = index;
    reach.value = position;
    reach.bound = position > limits.upper ? limits.upper : limits.lower;
  }
  return reach;
}

}  // namespace

const char* to_string(ReachRejection reason) {
  switch (reason) {
    case ReachRejection::too_far:
      return "too_far";
    case ReachRejection::position:
      return "position";
    case ReachRejection::orientation:
      return "orientation";
    case ReachRejection::joint_limit:
      break;
  }
  return "joint_limit";
}

const char* description(ReachRejection reason) {
  switch (reason) {
    case ReachRejection::too_far:
      return "beyond the length of the arm";
    case ReachRejection::position:
      return "the hand cannot be at this place";
    case ReachRejection::orientation:
      return "the hand cannot have this orientation at this place";
    case ReachRejection::joint_limit:
      break;
  }
  return "a joint would exceed its limits";
}

Reach reach_pose(const RobotModel& model, const Arm& arm, const Eigen::Isometry3d& T_root_tip,
                 const Eigen::VectorXd& positions, const InverseKinematicsOptions& options) {
  const Eigen::Isometry3d T_root_base = link_poses(model, positions)[arm.base_link];
  const Eigen::Isometry3d T_base_tip = T_root_base.inverse() * T_root_tip;
  const ArmChain chain = arm_chain(model, arm);
  const Eigen::VectorXd reference = arm_positions(arm, positions);
  const double distance = chain.distance_to(T_base_tip.translation());
  if (distance > chain.length() + options.position_tolerance)
    return rejected(ReachRejection::too_far, distance, chain.length());

  const InverseKinematicsResult found = inverse_kinematics(chain, T_base_tip, reference, options);
  if (found.converged()) {
    Reach reach;
    reach.positions = with_arm_positions(arm, found.positions, positions);
    return reach;
  }
  InverseKinematicsOptions unlimited = options;
  unlimited.limits = false;
  const auto free = inverse_kinematics(chain, T_base_tip, reference, unlimited);
  if (free.converged()) return beyond_limits(model, arm, free.positions);
  const auto at_point =
      inverse_kinematics_of_point(chain, T_base_tip.translation(), reference, unlimited);
  if (at_point.converged()) return rejected(ReachRejection::orientation, free.rotation_error, 0.0);
  return rejected(ReachRejection::position, at_point.position_error, 0.0);
}

Eigen::Isometry3d tip_of_tool(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                              const Eigen::Isometry3d& T_world_tool) {
  return robot.T_world_base.inverse() * T_world_tool * arm.T_tip_tool(gripper).inverse();
}

Reach reach_grasp(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                  const Grasp& grasp, const InverseKinematicsOptions& options) {
  return reach_pose(robot.model, arm.arm, tip_of_tool(robot, arm, gripper, grasp.T_world_tool),
                    robot.home, options);
}

}  // namespace symscene
