#pragma once

#include <optional>
#include <string>

#include "arguments.hpp"
#include "symscene/core/geometry.hpp"
#include "symscene/robots/robot.hpp"

namespace symscene::app {

/// The robot of a command, where it stands and how: --robot, --arm, --base and --start.
struct RobotChoice {
  std::string name = "panda";
  std::string arm_name, base, start;

  void add_to(Arguments& arguments);
  /// The robot with T_world_base of --base. Throws InputError if it cannot be read or --base is no
  /// pose.
  Robot robot() const;
  /// The arm of --arm; else the first with a gripper. Throws InputError if there is none.
  const RobotArm& arm(const Robot& robot) const;
  /// Positions of all moving joints: home, with those of --start. Throws InputError if a joint is
  /// unknown, its position is outside its limits, or the numbers are not those of the arm's joints.
  Eigen::VectorXd start_positions(const Robot& robot, const Arm& arm) const;
};

/// The pose "x,y,z,yaw" [m, degrees] or "x,y,z,qx,qy,qz,qw". Throws InputError, naming `where`, for
/// another text.
Eigen::Isometry3d parse_pose(const std::string& text, const std::string& where);

/// A sentence if the robot leans more than 20 degrees against the table: the scene is then hardly
/// in the frame in which the robot stands.
std::optional<std::string> leaning(const Robot& robot, const std::optional<Plane>& table);

}  // namespace symscene::app
