#include "approach_poses.hpp"

#include <cmath>
#include <limits>

#include "hand_collision.hpp"
#include "hand_shape.hpp"
#include "tool_pose.hpp"

namespace symscene {
namespace {

constexpr double least_difference =
    0.005;  // between the overhangs of a shallow and a deep grasp [m]

std::vector<Eigen::Vector3d> approach_directions(const GraspTarget& target, const ClosingLine& line,
                                                 const GraspCandidateOptions& options) {
  std::vector<Eigen::Vector3d> directions;
  // Straight down, or to an upright line away from the camera.
  const Eigen::Vector3d first = direction_across(line.direction, {-target.up, -target.seen_from});
  const int steps = static_cast<int>(std::floor(std::numbers::pi / options.approach_step + 1e-9));
  for (int k = -steps; k <= steps; ++k) {
    const Eigen::Vector3d z = Eigen::AngleAxisd(k * options.approach_step, line.direction) * first;
    if (angle_between(z, -target.up) <= options.max_tilt) directions.push_back(z);
  }
  return directions;
}

Eigen::Isometry3d pose_at(const ClosingLine& line, const Eigen::Vector3d& z, double tip_overhang,
                          const Gripper& gripper) {
  return tool_pose(line.centre - (gripper.finger_depth - tip_overhang) * z, line.direction, z);
}

GraspSource source_of(const ClosingLine& line, const Eigen::Vector3d& z) {
  constexpr double top_angle = radians(45.0);
  return line.axis && line_angle(*line.axis, z) < top_angle ? GraspSource::axis_top : line.source;
}

/// Appends the poses whose y axis is the line's direction.
void append_poses(const GraspTarget& target, const ClosingLine& line, const Gripper& gripper,
                  const std::optional<Plane>& table, const GraspOptions& options,
                  std::vector<ApproachPose>& poses) {
  const GraspCandidateOptions& made = options.candidates;
  const HandShape shape = hand_shape(gripper, gripper.max_opening, 0.0);
  const auto height = [&](const Eigen::Isometry3d& pose) {
    if (!table) return std::numeric_limits<double>::infinity();
    return height_over(*table, pose, shape.boxes);
  };
  for (const Eigen::Vector3d& z : approach_directions(target, line, made)) {
    const double descent = std::max(-z.dot(target.up), 1e-9);
    const double spare =
        height(pose_at(line, z, 0.0, gripper)) - options.bounds.table_clearance - 1e-6;
    const auto limited = [&](double tip_overhang) {
      return std::max(made.min_overhang, std::min(tip_overhang, spare / descent));
    };
    const double shallow = limited(made.shallow_overhang);
    const double deep = limited(std::min(made.deep_overhang, gripper.finger_depth));
    for (const double tip_overhang : {shallow, deep}) {
      const Eigen::Isometry3d pose = pose_at(line, z, tip_overhang, gripper);
      poses.push_back({pose, source_of(line, z), height(pose)});
      if (deep - shallow < least_difference) break;
    }
  }
}

}  // namespace

std::vector<ApproachPose> approach_poses(const GraspTarget& target, const ClosingLine& line,
                                         const Gripper& gripper, const std::optional<Plane>& table,
                                         const GraspOptions& options) {
  std::vector<ApproachPose> poses;
  append_poses(target, line, gripper, table, options, poses);
  if (gripper.kind == GripperKind::three_finger) {  // two fingers at +y against one
    ClosingLine reversed = line;
    reversed.direction = -line.direction;
    append_poses(target, reversed, gripper, table, options, poses);
  }
  return poses;
}

}  // namespace symscene
