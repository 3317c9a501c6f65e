#include "ros_json.hpp"

#include <cmath>

#include "io/pose_json.hpp"

namespace symscene {

std::int64_t nanoseconds_of(double seconds) { return std::llround(seconds * 1e9); }

Json RosJson::seconds(std::int64_t nanoseconds) const {
  constexpr std::int64_t second = 1'000'000'000;
  const bool is_ros1 = version_ == RosVersion::ros1;
  return {{is_ros1 ? "secs" : "sec", nanoseconds / second},
          {is_ros1 ? "nsecs" : "nanosec", nanoseconds % second}};
}

Json RosJson::duration(double value) const {
  to_json(value, what_);  // refuses what is not finite
  return seconds(nanoseconds_of(value));
}

Json RosJson::header(const std::string& frame) const {
  return {{"stamp", seconds(0)}, {"frame_id", frame}};
}

Json RosJson::vector(const Eigen::Vector3d& vector) const {
  return {{"x", number(vector.x())}, {"y", number(vector.y())}, {"z", number(vector.z())}};
}

Json RosJson::pose(const Eigen::Isometry3d& pose) const {
  const Eigen::Quaterniond q = orientation_of(pose);
  return {
      {"position", vector(pose.translation())},
      {"orientation",
       {{"x", number(q.x())}, {"y", number(q.y())}, {"z", number(q.z())}, {"w", number(q.w())}}}};
}

Json RosJson::numbers(const Eigen::VectorXd& values) const {
  Json json = Json::array();
  for (Eigen::Index i = 0; i < values.size(); ++i) json.push_back(number(values[i]));
  return json;
}

Json RosJson::joint_trajectory(const JointTrajectory& trajectory) const {
  Json points = Json::array();
  for (const JointTrajectoryPoint& point : trajectory.points) {
    points.push_back({{"positions", numbers(point.positions)},
                      {"velocities", numbers(point.velocities)},
                      {"accelerations", numbers(point.accelerations)},
                      {"effort", Json::array()},
                      {"time_from_start", duration(point.time)}});
  }
  return {{"header", header("")}, {"joint_names", trajectory.joint_names}, {"points", points}};
}

}  // namespace symscene
