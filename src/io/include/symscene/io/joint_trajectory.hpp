#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "symscene/core/grasp.hpp"
#include "symscene/core/joint_trajectory.hpp"
#include "symscene/io/ros_version.hpp"

namespace symscene {

/// A grasp that the arm does not reach.
struct GraspNotReached {
  std::size_t grasp = 0;  ///< index into the grasps, best first
  int object = 0;
  std::string reason;  ///< name of a PickRejection
  std::string detail;  ///< of a collision: what meets what
};

/// What a trajectory is for.
struct TrajectoryPurpose {
  std::string robot;      ///< as the user named it
  std::string arm;        ///< name of its arm
  std::size_t index = 0;  ///< of the grasp that the trajectory takes
  Grasp grasp;
  std::vector<GraspNotReached> not_reached = {};
};

/// The text of trajectory.json (docs/formats.md, docs/trajectory.schema.json): `joint_trajectory`
/// has the fields of trajectory_msgs/JointTrajectory. Throws InputError if a number is not finite,
/// the numbers of names and values differ, the trajectory does not begin and end at rest, or times
/// do not increase from 0 by whole nanoseconds.
std::string format_joint_trajectory_json(const JointTrajectory& trajectory,
                                         const TrajectoryPurpose& purpose,
                                         RosVersion version = RosVersion::ros2);

/// The points as CSV, one per line: time_s, part, and NAME_position, NAME_velocity,
/// NAME_acceleration of each joint. Throws InputError as above.
std::string format_joint_trajectory_csv(const JointTrajectory& trajectory);

}  // namespace symscene
