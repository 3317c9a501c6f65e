#include "camera_arm.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// Points on the surface of the cylinder in which objects may stand.
Points keep_out_points(const CameraLookOptions& options) {
  constexpr double spacing = 0.03;
  const auto steps = [](double length) { return std::max(1, static_cast<int>(length / spacing)); };
  std::vector<Eigen::Vector3f> points;
  const auto ring = [&](double radius, double height) {
    const int count = steps(2.0 * std::numbers::pi * radius);
    for (int k = 0; k < count; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / count;
      points.emplace_back(
          Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), height)
              .cast<float>());
    }
  };
  if (options.keep_out_radius <= 0.0 || options.keep_out_height <= 0.0) return Points(0, 3);
  const int up = steps(options.keep_out_height), out = steps(options.keep_out_radius);
  for (int k = 0; k <= up; ++k) ring(options.keep_out_radius, options.keep_out_height * k / up);
  for (int k = 0; k < out; ++k) ring(options.keep_out_radius * k / out, options.keep_out_height);
  Points rows(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  return rows;
}

const RobotArm& camera_arm(const Robot& robot) {
  if (!robot.camera || !robot.camera->arm)
    throw InputError("robot", "a camera that an arm carries", "none");
  return robot.arms[*robot.camera->arm];
}

}  // namespace

double azimuth_of_base(const Robot& robot) {
  const Eigen::Vector3d base = robot.T_world_base.translation();
  return std::atan2(base.y(), base.x());
}

CameraArm::CameraArm(const Robot& robot, const Gripper& gripper, const PickBin& bin,
                     const CameraLookOptions& options, const PickOptions& planning)
    : options_(options),
      planning_(planning),
      arm_(camera_arm(robot)),
      chain_(arm_chain(robot.model, arm_.arm)),
      space_(joint_space(robot.model, arm_.arm)),
      limits_(motion_limits(robot.model, arm_.arm, planning.speed)),
      obstacles_(scene(bin)),
      collision_(robot, arm_, arm_.gripper ? &gripper : nullptr, gripper.max_opening, obstacles_,
                 robot.home, planning.collision),
      home_(arm_positions(arm_.arm, robot.home)),
      azimuth_(azimuth_of_base(robot)) {
  const std::vector<Eigen::Isometry3d> links = link_poses(robot.model, robot.home);
  const std::vector<std::size_t> bodies = rigid_bodies(robot.model);
  if (bodies[robot.camera->link] != bodies[arm_.arm.tip_link])
    throw InputError("robot", "a camera that moves with the tip of its arm",
                     robot.model.links[robot.camera->link].name);
  T_table_base_ = robot.T_world_base * links[arm_.arm.base_link];
  T_camera_tip_ = (links[robot.camera->link] * robot.camera->T_link_camera).inverse() *
                  links[arm_.arm.tip_link];
}

GraspScene CameraArm::scene(const PickBin& bin) const {
  GraspScene scene;
  scene.table = Plane{};
  scene.obstacles = keep_out_points(options_);
  bin.add_walls_to(scene.obstacles);
  return scene;
}

std::string CameraArm::blocked_home() const {
  const auto met = collision_.contact(home_);
  if (!met) return {};
  if (met->other.kind != ObstacleKind::surface) return "at its home positions " + describe(*met);
  return fmt::format(
      "at its home positions {} is at the bin or in the space kept free for objects, within {:g} m "
      "of the table's middle and {:g} m above it (keep_out_radius, keep_out_height)",
      met->part, options_.keep_out_radius, options_.keep_out_height);
}

std::optional<Eigen::VectorXd> CameraArm::reach(const Eigen::Isometry3d& T_table_camera,
                                                const Eigen::VectorXd& start) const {
  InverseKinematicsOptions search;
  search.max_starts = 4;
  const auto found = inverse_kinematics(
      chain_, T_table_base_.inverse() * T_table_camera * T_camera_tip_, start, search);
  if (!found.converged() || collision_.contact(found.positions)) return std::nullopt;
  return found.positions;
}

Eigen::Isometry3d CameraArm::camera_pose(const Eigen::VectorXd& positions) const {
  return T_table_base_ * tip_pose(chain_, positions) * T_camera_tip_.inverse();
}

}  // namespace symscene
