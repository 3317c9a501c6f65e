#include "look_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/looking_at.hpp"

namespace symscene {
namespace {

constexpr double longest_turn = 1.5;  // of a joint between two stations [rad]
constexpr int radius_steps = 4;       // between the greatest and the least distance

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

double radius_at(const CameraLookOptions& options, int step) {
  return options.max_radius - (options.max_radius - options.min_radius) * step / radius_steps;
}

/// Stations in one direction, the best first: far, and near the elevation wanted there.
std::vector<Station> stations_at(const CameraLookOptions& options, double azimuth, double wanted) {
  constexpr int steps = 4;
  std::vector<Station> stations;
  for (int r = 0; r <= radius_steps; ++r) {
    const double radius = radius_at(options, r);
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

std::optional<Eigen::VectorXd> reach(const CameraArm& arm, const CameraLookOptions& options,
                                     const Station& station, const Eigen::VectorXd* before) {
  const auto found = arm.reach(station.pose(options.target_height), before ? *before : arm.home());
  if (!found || !before) return found;
  const bool is_near = (*found - *before).cwiseAbs().maxCoeff() < longest_turn;
  if (!is_near || !arm.collision().is_free(*before, *found)) return std::nullopt;
  return found;
}

/// Directions of views around the table, each with its elevation: first from the robot's side at
/// the middle elevation.
struct Direction {
  double azimuth, elevation;
};
std::vector<Direction> directions_around(const CameraLookOptions& options, double azimuth) {
  constexpr int count = 12;
  std::vector<Direction> directions;
  for (const double share : {0.5, 0.0, 1.0}) {
    const double elevation =
        options.min_elevation + share * (options.max_elevation - options.min_elevation);
    for (int k = 0; k < count; ++k)
      directions.push_back({azimuth + 2.0 * std::numbers::pi * k / count, elevation});
  }
  return directions;
}

/// The view of that direction from as far as the arm brings its camera.
std::optional<ViewStation> farthest_reached(const CameraArm& arm, const CameraLookOptions& options,
                                            double azimuth, double elevation) {
  for (int r = 0; r <= radius_steps; ++r) {
    const Station station{azimuth, elevation, radius_at(options, r)};
    const auto positions = arm.reach(station.pose(options.target_height), arm.home());
    if (positions) return ViewStation{*positions, arm.camera_pose(*positions)};
  }
  return std::nullopt;
}

std::vector<Eigen::VectorXd> reachable_stations(const CameraArm& arm,
                                                const CameraLookOptions& options) {
  std::vector<Eigen::VectorXd> reached;
  for (int k = 0; k < options.stations; ++k) {
    const double share = static_cast<double>(k) / (options.stations - 1);
    const double azimuth = arm.azimuth() + (share - 0.5) * options.arc;
    for (const Station& station : stations_at(options, azimuth, elevation_at(options, share))) {
      const auto positions =
          reach(arm, options, station, reached.empty() ? nullptr : &reached.back());
      if (!positions) continue;
      reached.push_back(*positions);
      break;
    }
  }
  return reached;
}

/// At the mean speed of the camera that is asked for, if the arm is able to.
TimedPath slow_sweep(const CameraArm& arm, double speed,
                     const std::vector<Eigen::VectorXd>& stations) {
  const auto camera_at = [&](const Eigen::VectorXd& positions) -> Eigen::Vector3d {
    return arm.camera_pose(positions).translation();
  };
  double way = 0.0;
  for (std::size_t i = 1; i < stations.size(); ++i)
    way += (camera_at(stations[i]) - camera_at(stations[i - 1])).norm();
  const TimedPath fastest = timed_motion(arm.planner(), stations);
  const MotionLimits slow = slowed(arm.limits(), std::max(1.0, way / (fastest.duration() * speed)));
  return timed_motion(arm.planner(slow), stations);
}

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

PlannedLook plan_look(const CameraArm& arm, const CameraLookOptions& options) {
  if (std::string blocked = arm.blocked_home(); !blocked.empty()) return {std::nullopt, blocked};
  const auto stations = reachable_stations(arm, options);
  if (stations.size() < 2) return {std::nullopt, too_few_views};
  const MotionPlanner planner = arm.planner();
  const FreeMotion there = plan_free_motion(planner, arm.home(), {stations.front()});
  if (!there.path) return {std::nullopt, "the camera's way to the table: " + there.obstacle};
  const FreeMotion back = plan_free_motion(planner, stations.back(), {arm.home()});
  if (!back.path) return {std::nullopt, "the camera's way back: " + back.obstacle};
  return {LookMotion{*there.path, slow_sweep(arm, options.speed, stations), *back.path}, {}};
}

std::vector<Eigen::Isometry3d> flying_views(const CameraLookOptions& options, double azimuth) {
  std::vector<Eigen::Isometry3d> poses;
  for (const auto& [turn, elevation] : directions_around(options, azimuth))
    poses.push_back(Station{turn, elevation, options.max_radius}.pose(options.target_height));
  return poses;
}

std::vector<ViewStation> view_stations(const CameraArm& arm, const CameraLookOptions& options) {
  std::vector<ViewStation> reached;
  for (const auto& [azimuth, elevation] : directions_around(options, arm.azimuth())) {
    if (auto station = farthest_reached(arm, options, azimuth, elevation))
      reached.push_back(std::move(*station));
  }
  return reached;
}

}  // namespace symscene
