#pragma once

#include <map>
#include <optional>
#include <vector>

#include "symscene/motion/joint_space.hpp"
#include "symscene/motion/pick.hpp"
#include "symscene/robots/inverse_kinematics.hpp"

namespace symscene {

/// Joint positions at which the arm can grasp, with the straight ways there and back.
struct PickCandidate {
  std::vector<Eigen::VectorXd> approach;  ///< from the pre-grasp to the grasp
  std::vector<Eigen::VectorXd> retreat;   ///< from the grasp
};

/// Joint positions for a pose of the hand.
struct HandPositions {
  Eigen::Isometry3d T_world_tool;
  bool is_turned = false;  ///< by half a turn against the grasp
  Eigen::VectorXd positions;
};

/// Finds joint positions for grasps. Straight ways are free of collisions, the pre-grasp too.
class PickCandidates {
 public:
  /// References are kept.
  PickCandidates(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                 const Eigen::VectorXd& start, const GraspScene& scene,
                 const MotionObstacles& obstacles, const PickOptions& options);

  /// Joint positions for a grasp, the nearest to the start first. None: `why` says the reason.
  std::vector<HandPositions> positions(const Grasp& grasp, RejectedPick& why) const;
  /// The straight ways to and from these positions. `holding`: as of holding_arm(). None: `why`
  /// says what stopped the candidate of the grasp that came farthest.
  std::optional<PickCandidate> candidate(const Grasp& grasp, const HandPositions& at_grasp,
                                         const ArmCollision& holding, RejectedPick& why) const;
  /// With the object of the grasp in the gripper, which may touch what it touches there.
  ArmCollision holding_arm(const Grasp& grasp, const HandPositions& at_grasp);

  /// With open gripper, for motions to the pre-grasp.
  const ArmCollision& open_arm() const { return open_; }
  const JointSpace& space() const { return space_; }

 private:
  void add_positions(const Eigen::Isometry3d& T_world_tool, bool is_turned,
                     std::vector<HandPositions>& all, RejectedPick& why) const;
  std::optional<std::vector<Eigen::VectorXd>> line(const HandPositions& from,
                                                   const Eigen::Vector3d& offset_world) const;
  PickRejection reason_unreachable(const Eigen::Isometry3d& T_base_tip) const;
  Eigen::Isometry3d T_base_tip(const Eigen::Isometry3d& T_world_tool) const;
  std::vector<Eigen::Vector3d> retreat_directions(const Eigen::Isometry3d& T_world_tool) const;
  const std::vector<Eigen::Vector3f>& surface_of(std::size_t object);

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
  Eigen::Isometry3d T_world_base_;                                ///< of the arm's base link
  std::map<std::size_t, std::vector<Eigen::Vector3f>> surfaces_;  ///< of objects that were held
};

}  // namespace symscene
