#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "symscene/motion/pick.hpp"

namespace symscene::app {

/// The motion for the best grasp that the arm reaches, and which others it reaches. Indices into
/// the grasps.
struct PlannedPick {
  std::optional<PickMotion> motion;
  std::vector<std::size_t> reached;
  std::vector<RejectedPick> rejected;
  std::string start_contact;  ///< why the arm cannot move at all
  std::vector<StageTime> timings;
};

/// Plans a motion for the best of `grasps`; with `all` also for each other one, to tell whether the
/// arm reaches it. Throws as plan_pick().
PlannedPick planned_pick(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                         const Eigen::VectorXd& start, const GraspScene& scene,
                         std::span<const Grasp> grasps, const PickOptions& options, bool all);

}  // namespace symscene::app
