#pragma once

#include <optional>
#include <span>

#include "symscene/motion/pick_survey.hpp"
#include "symscene/viewer/plan_page.hpp"

namespace symscene::app {

/// What a page of a plan shows. References are kept.
struct PlanToShow {
  const Robot& robot;
  const RobotArm& arm;
  const Gripper& gripper;
  const Eigen::VectorXd& start;  ///< positions of all moving joints
  const GraspScene& scene;
  std::span<const Grasp> grasps;
  std::span<const std::size_t> numbers;  ///< of these grasps among all
  const PickSurvey& pick;
  const std::optional<JointTrajectory>& trajectory;  ///< none if no grasp is reached
};

/// The motion, what became of each grasp, and where on the table the arm reaches. The frame of the
/// table has its origin on it and z up.
PlanRecording plan_recording(const PlanToShow& plan);

}  // namespace symscene::app
