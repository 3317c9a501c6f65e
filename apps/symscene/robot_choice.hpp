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
  /// A robot that leans more than 20 degrees against the table is mounted on a wall or a ceiling,
  /// or the scene is in another frame than its base_pose. Only a --base with a whole orientation
  /// says the former: a sentence then. Throws InputError otherwise.
  std::optional<std::string> check_stand(const Robot& robot,
                                         const std::optional<Plane>& table) const;
  /// The arm of --arm; else the first with a gripper. Throws InputError if there is none.
  const RobotArm& arm(const Robot& robot) const;
  /// Positions of all moving joints: home, with those of --start. Throws InputError if a joint is
  /// unknown, its position is outside its limits, or the numbers are not those of the arm's joints.
  Eigen::VectorXd start_positions(const Robot& robot, const Arm& arm) const;
};

/// The pose "x,y,z,yaw" [m, degrees] or "x,y,z,qx,qy,qz,qw". Throws InputError, naming `where`, for
/// another text.
Eigen::Isometry3d parse_pose(const std::string& text, const std::string& where);

/// An included robot or the one that a YAML file describes. Throws InputError, naming --robot, for
/// another name, and as read_robot() does.
Robot named_robot(const std::string& name);

}  // namespace symscene::app
