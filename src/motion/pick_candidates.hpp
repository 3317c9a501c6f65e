#pragma once

#include "symscene/motion/pick.hpp"
#include "symscene/robots/inverse_kinematics.hpp"

namespace symscene {

/// Joint positions at which the arm can grasp, with the straight ways there and back.
struct PickCandidate {
  std::vector<Eigen::VectorXd> approach;  ///< from the pre-grasp to the grasp
  std::vector<Eigen::VectorXd> retreat;   ///< from the grasp
};

/// Finds joint positions for grasps. Straight ways are free of collisions, the pre-grasp too.
class PickCandidates {
 public:
  /// References are kept.
  PickCandidates(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                 const Eigen::VectorXd& start, const GraspScene& scene,
                 const MotionObstacles& obstacles, const PickOptions& options);

  /// None of a grasp: `why` says which step most candidates came to, and what stopped it.
  std::vector<PickCandidate> find(const Grasp& grasp, RejectedPick& why) const;
  /// With open gripper, for motions to the pre-grasp.
  const ArmCollision& open_arm() const { return open_; }
  const JointSpace& space() const { return space_; }

 private:
  void add_candidates(const Grasp& grasp, const Eigen::Isometry3d& T_world_tool,
                      std::vector<PickCandidate>& candidates, RejectedPick& why) const;
  std::optional<PickCandidate> candidate(const Grasp& grasp, const Eigen::Isometry3d& T_base_tip,
                                         const Eigen::VectorXd& at_grasp,
                                         const ArmCollision& holding, RejectedPick& why) const;
  PickRejection reason_unreachable(const Eigen::Isometry3d& T_base_tip) const;
  Eigen::Vector3d retreat_direction(const Eigen::Isometry3d& T_world_tool) const;
  ArmCollision holding_arm(const Grasp& grasp, const Eigen::Isometry3d& T_world_tool) const;

  const Robot& robot_;
  const RobotArm& arm_;
  const Gripper& gripper_;
  const Eigen::VectorXd& start_;
  const GraspScene& scene_;
  const MotionObstacles& obstacles_;
  const PickOptions& options_;
  ArmChain chain_;
  JointSpace space_;
  ArmCollision open_;
  Eigen::Isometry3d T_world_base_;  ///< of the arm's base link
};

}  // namespace symscene
