#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace symscene {

/// The joints at one time.
struct JointTrajectoryPoint {
  double time = 0.0;              ///< from the start of the trajectory [s]
  Eigen::VectorXd positions;      ///< [rad or m]
  Eigen::VectorXd velocities;     ///< [1/s]
  Eigen::VectorXd accelerations;  ///< [1/s²]
};

/// A named part: points `begin` to `end`, both included. A part begins where the one before ends.
struct JointTrajectoryPart {
  std::string name;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The opening between the fingers from a time on. [s, m]
struct GripperCommand {
  double time = 0.0;
  double opening = 0.0;
};

/// What a controller of joints follows. Times increase strictly from 0; first and last velocities
/// are zero.
struct JointTrajectory {
  std::vector<std::string> joint_names;
  std::vector<JointTrajectoryPoint> points;
  std::vector<JointTrajectoryPart> parts = {};
  std::vector<GripperCommand> gripper = {};
};

}  // namespace symscene
