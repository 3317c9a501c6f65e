#pragma once

#include <cstdint>
#include <string>

#include <Eigen/Geometry>

#include "io/json_cursor.hpp"
#include "symscene/core/joint_trajectory.hpp"
#include "symscene/io/ros_version.hpp"

namespace symscene {

/// Messages of ROS as JSON by the names of their fields. All of it throws InputError, with `what`
/// as the file, if a number is not finite.
class RosJson {
 public:
  RosJson(RosVersion version, const char* what) : version_(version), what_(what) {}

  /// builtin_interfaces/Duration: whole seconds and nanoseconds.
  Json duration(double seconds) const;
  /// std_msgs/Header with time 0, which stands for the latest transform.
  Json header(const std::string& frame) const;
  /// geometry_msgs/Vector3 or Point.
  Json vector(const Eigen::Vector3d& vector) const;
  /// geometry_msgs/Pose.
  Json pose(const Eigen::Isometry3d& pose) const;
  /// trajectory_msgs/JointTrajectory; of a frame that joints do not need.
  Json joint_trajectory(const JointTrajectory& trajectory) const;
  Json number(double value) const { return to_json(value, what_); }

 private:
  Json numbers(const Eigen::VectorXd& values) const;
  Json seconds(std::int64_t nanoseconds) const;

  RosVersion version_;
  const char* what_;
};

/// A time in whole nanoseconds.
std::int64_t nanoseconds_of(double seconds);

}  // namespace symscene
