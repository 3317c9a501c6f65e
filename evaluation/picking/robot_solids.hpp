#pragma once

#include <vector>

#include "symscene/core/gripper.hpp"
#include "symscene/robots/robot.hpp"
#include "symscene/viewer/run_page.hpp"

namespace symscene {

/// Where a robot's joints and its fingers are.
struct RobotState {
  Eigen::VectorXd positions;  ///< of all moving joints
  double opening = 0.0;       ///< between the fingers [m]
};

/// The links of a robot as their capsules, and its hand as the gripper's boxes.
class RobotSolids {
 public:
  RobotSolids(const Robot& robot, const RobotArm& arm, const Gripper& gripper);

  /// Links with capsules, then palm and fingers.
  const std::vector<RecordedSolid>& solids() const { return solids_; }
  /// T_world_solid of each.
  std::vector<Eigen::Isometry3d> poses(const RobotState& state) const;

 private:
  const Robot& robot_;
  Eigen::Isometry3d T_tip_tool_;
  std::size_t tip_link_;
  std::vector<std::size_t> links_;  ///< of the first solids
  std::vector<RecordedSolid> solids_;
};

}  // namespace symscene
