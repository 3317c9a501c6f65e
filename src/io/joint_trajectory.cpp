#include "symscene/io/joint_trajectory.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "io/pose_json.hpp"
#include "ros_json.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr const char* trajectory_to_write = "trajectory to write";
constexpr std::size_t trajectory_version = 1;

void require_values(const Eigen::VectorXd& values, std::size_t joints) {
  if (static_cast<std::size_t>(values.size()) == joints && values.allFinite()) return;
  throw InputError(trajectory_to_write, fmt::format("{} finite numbers per point", joints),
                   values.allFinite() ? fmt::format("{}", values.size()) : "others");
}

void require_rest(const JointTrajectoryPoint& point) {
  if (!point.velocities.isZero(0.0))
    throw InputError(trajectory_to_write, "velocities of 0 at its ends",
                     fmt::format("{:g}", point.velocities.cwiseAbs().maxCoeff()));
}

void require_valid(const JointTrajectory& trajectory) {
  if (trajectory.points.empty()) throw InputError(trajectory_to_write, "points", "none");
  std::int64_t before = -1;
  for (const JointTrajectoryPoint& point : trajectory.points) {
    for (const auto* values : {&point.positions, &point.velocities, &point.accelerations})
      require_values(*values, trajectory.joint_names.size());
    to_json(point.time, trajectory_to_write);
    const std::int64_t now = nanoseconds_of(point.time);
    if (before < 0 ? now != 0 : now <= before)
      throw InputError(
          trajectory_to_write, "times that increase strictly from 0",
          fmt::format("{} s after {} ns", point.time, std::max<std::int64_t>(before, 0)));
    before = now;
  }
  require_rest(trajectory.points.front());
  require_rest(trajectory.points.back());
}

/// The part that leads to a point.
std::string part_at(const JointTrajectory& trajectory, std::size_t point) {
  const auto part = std::find_if(
      trajectory.parts.begin(), trajectory.parts.end(),
      [&](const JointTrajectoryPart& p) { return point >= p.begin && point <= p.end; });
  return part == trajectory.parts.end() ? "" : part->name;
}

Json parts_json(const JointTrajectory& trajectory) {
  Json parts = Json::array();
  for (const JointTrajectoryPart& part : trajectory.parts)
    parts.push_back({{"name", part.name}, {"begin", part.begin}, {"end", part.end}});
  return parts;
}

Json gripper_commands(const JointTrajectory& trajectory, const RosJson& ros) {
  Json commands = Json::array();
  for (const GripperCommand& command : trajectory.gripper) {
    commands.push_back({{"time_from_start", ros.duration(command.time)},
                        {"opening_m", ros.number(command.opening)}});
  }
  return commands;
}

Json not_reached_json(const std::vector<GraspNotReached>& grasps) {
  Json list = Json::array();
  for (const GraspNotReached& grasp : grasps) {
    Json json = {{"grasp", grasp.grasp}, {"object", grasp.object}, {"reason", grasp.reason}};
    if (!grasp.detail.empty()) json["detail"] = grasp.detail;
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace

std::string format_joint_trajectory_json(const JointTrajectory& trajectory,
                                         const TrajectoryPurpose& purpose, RosVersion ros_version) {
  require_valid(trajectory);
  const RosJson ros(ros_version, trajectory_to_write);
  Json json = {{"version", trajectory_version}, {"robot", purpose.robot}, {"arm", purpose.arm}};
  json["grasp"] = {{"index", purpose.index},
                   {"object", purpose.grasp.object},
                   {"quality", ros.number(purpose.grasp.quality)},
                   {"opening_m", ros.number(purpose.grasp.opening)},
                   {"T_world_tool", pose_json(purpose.grasp.T_world_tool, trajectory_to_write)}};
  json["joint_trajectory"] = ros.joint_trajectory(trajectory);
  json["parts"] = parts_json(trajectory);
  json["gripper"] = gripper_commands(trajectory, ros);
  json["not_reached"] = not_reached_json(purpose.not_reached);
  return format_json(json);
}

std::string format_joint_trajectory_csv(const JointTrajectory& trajectory) {
  require_valid(trajectory);
  std::string text = "time_s,part";
  for (const std::string& name : trajectory.joint_names)
    text += fmt::format(",{0}_position,{0}_velocity,{0}_acceleration", name);
  for (std::size_t i = 0; i < trajectory.points.size(); ++i) {
    const JointTrajectoryPoint& point = trajectory.points[i];
    text += fmt::format("\n{},{}", point.time, part_at(trajectory, i));
    for (Eigen::Index k = 0; k < point.positions.size(); ++k)
      text +=
          fmt::format(",{},{},{}", point.positions[k], point.velocities[k], point.accelerations[k]);
  }
  return text + "\n";
}

}  // namespace symscene
