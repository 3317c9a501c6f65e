#include "cylinder_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tool_pose.hpp"

namespace symscene {
namespace {

/// Unit vectors across the axis, evenly over `span`. [rad]
std::vector<Eigen::Vector3d> directions_across(const Eigen::Vector3d& axis, int count,
                                               double span) {
  const Eigen::Matrix<double, 3, 2> basis = orthonormal_complement(axis);
  std::vector<Eigen::Vector3d> directions;
  for (int k = 0; k < count; ++k) {
    const double angle = span * k / count;
    directions.emplace_back(basis * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return directions;
}

/// Heights over the middle of a cylinder at which the whole width of the fingers lies on it.
std::vector<double> side_heights(double height, double finger_width, double step) {
  const double most = std::max(0.0, 0.5 * (height - finger_width));
  const int steps = static_cast<int>(most / step);
  std::vector<double> heights;
  for (int k = -steps; k <= steps; ++k) heights.push_back(k * step);
  return heights;
}

void add_side_grasps(const BoundingCylinder& cylinder, const Gripper& gripper,
                     const CylinderGraspOptions& options,
                     std::vector<CylinderCandidate>& candidates) {
  const double palm_distance =
      std::max(cylinder.radius + options.palm_clearance, gripper.finger_depth - cylinder.radius);
  const std::vector<double> heights =
      side_heights(cylinder.height, gripper.finger_width, options.height_step);
  for (const Eigen::Vector3d& approach :
       directions_across(cylinder.direction, options.directions, 2.0 * std::numbers::pi)) {
    for (const double height : heights) {
      const Eigen::Vector3d origin =
          cylinder.center + height * cylinder.direction - palm_distance * approach;
      candidates.push_back({tool_pose(origin, approach.cross(cylinder.direction), approach), height,
                            gripper.finger_depth - palm_distance});
    }
  }
}

/// From the end of the cylinder to which `outwards` points.
void add_end_grasps(const BoundingCylinder& cylinder, const Eigen::Vector3d& outwards,
                    const Gripper& gripper, const CylinderGraspOptions& options,
                    std::vector<CylinderCandidate>& candidates) {
  const double inside =
      std::min(gripper.finger_depth - options.palm_clearance,
               std::max(cylinder.height - options.palm_clearance, 0.5 * cylinder.height));
  const double to_origin = 0.5 * cylinder.height + gripper.finger_depth - inside;
  const double offset = 0.5 * (cylinder.height - inside);
  // Half a turn exchanges the fingers of a parallel gripper.
  const bool is_parallel = gripper.kind == GripperKind::parallel;
  const int turns = is_parallel ? (options.directions + 1) / 2 : options.directions;
  const double span = (is_parallel ? 1.0 : 2.0) * std::numbers::pi;
  for (const Eigen::Vector3d& closing : directions_across(cylinder.direction, turns, span)) {
    candidates.push_back(
        {tool_pose(cylinder.center + to_origin * outwards, closing, -outwards), offset, inside});
  }
}

}  // namespace

std::vector<CylinderCandidate> cylinder_candidates(const BoundingCylinder& cylinder,
                                                   const Gripper& gripper,
                                                   const CylinderGraspOptions& options) {
  std::vector<CylinderCandidate> candidates;
  add_side_grasps(cylinder, gripper, options, candidates);
  for (const double sign : {1.0, -1.0})
    add_end_grasps(cylinder, sign * cylinder.direction, gripper, options, candidates);
  return candidates;
}

}  // namespace symscene
