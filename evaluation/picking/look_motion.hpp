#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pick_bin.hpp"
#include "symscene/motion/pick.hpp"
#include "symscene/motion/trajectory.hpp"
#include "symscene/picking/camera_look_options.hpp"
#include "symscene/robots/robot.hpp"

namespace symscene {

/// The motion of the arm that carries the camera past the table, from the robot's home
/// configuration and back.
struct LookMotion {
  TimedPath there;
  TimedPath sweep;  ///< during which images are taken
  TimedPath back;
};

/// A look that was planned, or why there is none.
struct PlannedLook {
  std::optional<LookMotion> motion;
  std::string obstacle;  ///< why there is no motion
};

/// The poses of a camera that flies along the arc of a look without an arm: one per frame. Frame of
/// the table; the middle of the arc is at `azimuth`.
std::vector<Eigen::Isometry3d> flying_look(const CameraLookOptions& options, double azimuth);

/// Directions about the table's middle are tried in turn. In each the arm takes the first pose of
/// the camera, the farthest first, that it reaches without collision and near the pose before.
/// Throws InputError if the robot has no camera on an arm, or the camera does not move with the
/// arm's tip.
PlannedLook plan_look(const Robot& robot, const Gripper& gripper, const PickBin& bin,
                      const CameraLookOptions& options, const PickOptions& planning);

}  // namespace symscene
