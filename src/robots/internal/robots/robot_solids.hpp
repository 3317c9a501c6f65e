#pragma once

#include <string>
#include <vector>

#include "symscene/core/gripper.hpp"
#include "symscene/core/triangle_mesh.hpp"
#include "symscene/robots/robot.hpp"

namespace symscene {

/// Where a robot's joints and its fingers are.
struct RobotState {
  Eigen::VectorXd positions;  ///< of all moving joints
  double opening = 0.0;       ///< between the fingers [m]
};

/// A rigid part of a robot to draw, in its own frame [m].
struct RobotSolid {
  std::string name;
  TriangleMesh mesh;
  bool is_hand = false;  ///< palm or finger
};

/// The links of a robot as their capsules, and its hand as the gripper's boxes.
class RobotSolids {
 public:
  /// `robot` is kept.
  RobotSolids(const Robot& robot, const RobotArm& arm, const Gripper& gripper);

  /// Links with capsules, then palm and fingers.
  const std::vector<RobotSolid>& solids() const { return solids_; }
  /// T_world_solid of each.
  std::vector<Eigen::Isometry3d> poses(const RobotState& state) const;
  /// T_world_tool.
  Eigen::Isometry3d tool(const RobotState& state) const;

 private:
  const Robot& robot_;
  Eigen::Isometry3d T_tip_tool_;
  std::size_t tip_link_;
  std::vector<std::size_t> links_;  ///< of the first solids
  std::vector<RobotSolid> solids_;
};

}  // namespace symscene
