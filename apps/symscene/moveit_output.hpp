#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "io/thinned_surfaces.hpp"
#include "symscene/grasping/planner.hpp"
#include "symscene/io/moveit.hpp"
#include "symscene/robots/robot.hpp"

namespace symscene::app {

/// What is written for MoveIt. References are kept.
struct MoveItContent {
  const Robot& robot;
  const RobotArm& arm;
  const Gripper& gripper;
  const GraspScene& scene;
  const std::vector<Grasp>& grasps;
  const std::optional<JointTrajectory>& trajectory;
};

/// Files for MoveIt: --moveit, --grasping-msgs, --finger-joints and --ros.
struct MoveItOutput {
  std::filesystem::path path;           ///< moveit_msgs; empty: nothing is written
  std::filesystem::path grasping_path;  ///< grasping_msgs; empty: nothing is written
  std::string finger_joints, ros = "2";

  void add_to(Arguments& arguments);
  bool is_wanted() const { return !path.empty() || !grasping_path.empty(); }
  /// Throws InputError if a name ends neither in .json nor in .yaml, or --finger-joints is given
  /// without a file or is no list of joints.
  void check() const;
  RosVersion version() const { return ros == "1" ? RosVersion::ros1 : RosVersion::ros2; }
  /// Writes poses of the arm's tip link, in the frame of the robot's root link. Returns a sentence
  /// about thinned surfaces.
  std::string write(const MoveItContent& content) const;

 private:
  std::vector<FingerJoint> joints_of(const RobotArm& arm, const Gripper& gripper) const;
};

}  // namespace symscene::app
