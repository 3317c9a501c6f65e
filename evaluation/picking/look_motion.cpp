#include "look_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/looking_at.hpp"
#include "free_motion.hpp"
#include "symscene/core/error.hpp"
#include "symscene/robots/inverse_kinematics.hpp"

namespace symscene {
namespace {

constexpr double longest_turn = 1.5;  // of a joint between two stations [rad]

/// Where cameras stand.
struct Station {
  double azimuth, elevation, radius;

  Eigen::Isometry3d pose(double target_height) const {
    const Eigen::Vector3d target(0.0, 0.0, target_height);
    const Eigen::Vector3d away(std::cos(elevation) * std::cos(azimuth),
                               std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
    return looking_at(target + radius * away, target);
  }
};

/// Along the arc the camera rises from its lowest to its highest elevation and comes back.
double elevation_at(const CameraLookOptions& options, double share) {
  return options.min_elevation +
         (options.max_elevation - options.min_elevation) * std::sin(std::numbers::pi * share);
}

/// Stations in one direction, the best first: far, and near the elevation wanted there.
std::vector<Station> stations_at(const CameraLookOptions& options, double azimuth, double wanted) {
  constexpr int steps = 4;
  std::vector<Station> stations;
  for (int r = 0; r <= steps; ++r) {
    const double radius =
        options.max_radius - (options.max_radius - options.min_radius) * r / steps;
    std::vector<Station> ring;
    for (int e = 0; e <= steps; ++e) {
      const double elevation =
          options.min_elevation + (options.max_elevation - options.min_elevation) * e / steps;
      ring.push_back({azimuth, elevation, radius});
    }
    std::stable_sort(ring.begin(), ring.end(), [&](const Station& a, const Station& b) {
      return std::abs(a.elevation - wanted) < std::abs(b.elevation - wanted);
    });
    stations.insert(stations.end(), ring.begin(), ring.end());
  }
  return stations;
}

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

/// One call of plan_look().
class LookPlanner {
 public:
  LookPlanner(const Robot& robot, const Gripper& gripper, const PickBin& bin,
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
        home_(arm_positions(arm_.arm, robot.home)) {
    const std::vector<Eigen::Isometry3d> links = link_poses(robot.model, robot.home);
    const std::vector<std::size_t> bodies = rigid_bodies(robot.model);
    if (bodies[robot.camera->link] != bodies[arm_.arm.tip_link])
      throw InputError("robot", "a camera that moves with the tip of its arm",
                       robot.model.links[robot.camera->link].name);
    T_table_base_ = robot.T_world_base * links[arm_.arm.base_link];
    T_camera_tip_ = (links[robot.camera->link] * robot.camera->T_link_camera).inverse() *
                    links[arm_.arm.tip_link];
    const Eigen::Vector3d base = robot.T_world_base.translation();
    azimuth_ = std::atan2(base.y(), base.x());
  }

  PlannedLook plan() const {
    if (const auto met = collision_.contact(home_)) return {std::nullopt, blocked_home(*met)};
    const auto stations = reachable_stations();
    if (stations.size() < 2)
      return {std::nullopt, "the arm brings its camera to no two poses that see the table"};
    const MotionPlanner planner{collision_, space_, limits_, planning_.rrt};
    const FreeMotion there = plan_free_motion(planner, home_, {stations.front()});
    if (!there.path) return {std::nullopt, "the camera's way to the table: " + there.obstacle};
    const FreeMotion back = plan_free_motion(planner, stations.back(), {home_});
    if (!back.path) return {std::nullopt, "the camera's way back: " + back.obstacle};
    return {LookMotion{*there.path, slow_sweep(stations), *back.path}, {}};
  }

 private:
  GraspScene scene(const PickBin& bin) const {
    GraspScene scene;
    scene.table = Plane{};
    scene.obstacles = keep_out_points(options_);
    bin.add_walls_to(scene.obstacles);
    return scene;
  }

  std::string blocked_home(const RobotContact& met) const {
    if (met.other.kind != ObstacleKind::surface) return "at its home positions " + describe(met);
    return fmt::format(
        "at its home positions {} is at the bin or in the space kept free for objects, within {:g} "
        "m of the table's middle and {:g} m above it (keep_out_radius, keep_out_height)",
        met.part, options_.keep_out_radius, options_.keep_out_height);
  }

  std::vector<Eigen::VectorXd> reachable_stations() const {
    std::vector<Eigen::VectorXd> reached;
    for (int k = 0; k < options_.stations; ++k) {
      const double share = static_cast<double>(k) / (options_.stations - 1);
      const auto candidates = stations_at(options_, azimuth_ + (share - 0.5) * options_.arc,
                                          elevation_at(options_, share));
      for (const Station& station : candidates) {
        const auto positions = reach(station, reached.empty() ? nullptr : &reached.back());
        if (!positions) continue;
        reached.push_back(*positions);
        break;
      }
    }
    return reached;
  }

  std::optional<Eigen::VectorXd> reach(const Station& station,
                                       const Eigen::VectorXd* before) const {
    InverseKinematicsOptions search;
    search.max_starts = 4;
    const Eigen::Isometry3d T_base_tip =
        T_table_base_.inverse() * station.pose(options_.target_height) * T_camera_tip_;
    const auto found = inverse_kinematics(chain_, T_base_tip, before ? *before : home_, search);
    if (!found.converged() || collision_.contact(found.positions)) return std::nullopt;
    if (!before) return found.positions;
    const bool is_near = (found.positions - *before).cwiseAbs().maxCoeff() < longest_turn;
    if (!is_near || !collision_.is_free(*before, found.positions)) return std::nullopt;
    return found.positions;
  }

  Eigen::Vector3d camera_at(const Eigen::VectorXd& positions) const {
    return (tip_pose(chain_, positions) * T_camera_tip_.inverse()).translation();
  }

  /// At the mean speed of the camera that is asked for, if the arm is able to.
  TimedPath slow_sweep(const std::vector<Eigen::VectorXd>& stations) const {
    double way = 0.0;
    for (std::size_t i = 1; i < stations.size(); ++i)
      way += (camera_at(stations[i]) - camera_at(stations[i - 1])).norm();
    const TimedPath fastest = timed_motion({collision_, space_, limits_, planning_.rrt}, stations);
    const double factor = std::max(1.0, way / (fastest.duration() * options_.speed));
    const MotionLimits slow = slowed(limits_, factor);
    return timed_motion({collision_, space_, slow, planning_.rrt}, stations);
  }

  const CameraLookOptions& options_;
  const PickOptions& planning_;
  const RobotArm& arm_;
  ArmChain chain_;
  JointSpace space_;
  MotionLimits limits_;
  MotionObstacles obstacles_;
  ArmCollision collision_;
  Eigen::VectorXd home_;
  Eigen::Isometry3d T_table_base_;
  Eigen::Isometry3d T_camera_tip_;
  double azimuth_ = 0.0;
};

}  // namespace

std::vector<Eigen::Isometry3d> flying_look(const CameraLookOptions& options, double azimuth) {
  std::vector<Eigen::Isometry3d> poses;
  for (int k = 0; k < options.frames; ++k) {
    const double share = options.frames > 1 ? static_cast<double>(k) / (options.frames - 1) : 0.5;
    const Station station{azimuth + (share - 0.5) * options.arc, elevation_at(options, share),
                          options.max_radius};
    poses.push_back(station.pose(options.target_height));
  }
  return poses;
}

PlannedLook plan_look(const Robot& robot, const Gripper& gripper, const PickBin& bin,
                      const CameraLookOptions& options, const PickOptions& planning) {
  return LookPlanner(robot, gripper, bin, options, planning).plan();
}

}  // namespace symscene
