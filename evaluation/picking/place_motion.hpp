#pragma once

#include <optional>
#include <string>

#include "pick_bin.hpp"
#include "symscene/grasping/planner.hpp"
#include "symscene/motion/pick.hpp"

namespace symscene {

/// What a motion of the grasping arm is planned in. References are kept.
struct PickScene {
  const Robot& robot;
  const RobotArm& arm;
  const Gripper& gripper;
  const GraspScene& scene;  ///< with the bin's walls among its obstacles
  const PickBin& bin;
  const SimulatedPickOptions& options;
};

/// A motion that carries an object to above the bin, or why there is none.
struct PlaceMotion {
  std::optional<TimedPath> path;
  std::string obstacle;
};

/// From the end of the retreat of `pick` to a pose at which the held object hangs above the bin: up
/// and around the arm's base with the object upright, else any way, at the end also with the hand
/// pointing down. The object's middle accelerates by at most `carry_acceleration`.
PlaceMotion plan_place(const PickScene& in, const Eigen::VectorXd& start, const PickMotion& pick,
                       const Grasp& grasp);

/// A motion of the empty arm to its home configuration among the obstacles of the scene.
/// `without`: an object that is no longer there; −1 for none.
PlaceMotion plan_home(const PickScene& in, const Eigen::VectorXd& start, int without);

}  // namespace symscene
