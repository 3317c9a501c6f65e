#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "symscene/grasping/planner.hpp"
#include "symscene/io/moveit.hpp"
#include "symscene/robots/robot.hpp"

namespace symscene::app {

/// Grasps and obstacles for MoveIt: --moveit, --finger-joints and --ros.
struct MoveItOutput {
  std::filesystem::path path;  ///< empty: nothing is written
  std::string finger_joints, ros = "2";

  void add_to(Arguments& arguments);
  /// Throws InputError if the name ends neither in .json nor in .yaml, or --finger-joints is given
  /// without a file.
  void check() const;
  RosVersion version() const { return ros == "1" ? RosVersion::ros1 : RosVersion::ros2; }
  /// Writes poses of the arm's tip link, in the frame of the robot's root link.
  void write(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
             const GraspScene& scene, const std::vector<Grasp>& grasps) const;
};

}  // namespace symscene::app
