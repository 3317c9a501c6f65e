#pragma once

#include "symscene/motion/pick.hpp"

namespace symscene {

/// Which grasps an arm can take. Indices into the grasps.
struct PickSurvey {
  std::optional<PickMotion> motion;  ///< for the first of `reached`
  std::vector<std::size_t> reached;
  std::vector<RejectedPick> rejected;  ///< in the order of the grasps
  std::string start_contact;           ///< why the arm cannot move at all: what it meets already
  std::vector<StageTime> timings;
};

/// As plan_pick(), but goes on after the first grasp that the arm reaches, until all are judged;
/// max_grasps does not apply. Throws as plan_pick().
PickSurvey survey_picks(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                        const Eigen::VectorXd& start, const GraspScene& scene,
                        std::span<const Grasp> grasps, const PickOptions& options = {});

/// The survey that plan_pick() makes: it stops at the first grasp that the arm reaches.
PickSurvey as_survey(PickResult result);

}  // namespace symscene
