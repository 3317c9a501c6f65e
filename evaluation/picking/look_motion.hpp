#pragma once

#include <optional>
#include <string>
#include <vector>

#include "camera_arm.hpp"

namespace symscene {

constexpr const char* too_few_views =
    "the arm brings its camera to no two poses that see the table";

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
PlannedLook plan_look(const CameraArm& arm, const CameraLookOptions& options);

/// Views from all around the table's middle at the middle, the least and the greatest elevation, at
/// the greatest distance, from `azimuth` on. T_table_camera.
std::vector<Eigen::Isometry3d> flying_views(const CameraLookOptions& options, double azimuth);

/// A pose of the camera that the arm reaches without collision. Frame of the table.
struct ViewStation {
  Eigen::VectorXd positions;  ///< of the arm's joints
  Eigen::Isometry3d T_table_camera;
};

/// The same for an arm, from the robot's side on: of each direction the farthest that it reaches.
std::vector<ViewStation> view_stations(const CameraArm& arm, const CameraLookOptions& options);

}  // namespace symscene
