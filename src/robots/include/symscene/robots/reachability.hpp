#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "symscene/core/grasp.hpp"
#include "symscene/core/gripper.hpp"
#include "symscene/robots/inverse_kinematics.hpp"
#include "symscene/robots/robot.hpp"

namespace symscene {

/// Why an arm does not reach a pose, whatever it might collide with.
enum class ReachRejection : std::uint8_t {
  too_far,      ///< beyond the length of the arm
  position,     ///< no orientation of the tip is possible at this place, e.g. too near the base
  orientation,  ///< the place is reached, but not with this orientation
  joint_limit   ///< reached only if a joint exceeds its limits
};
/// The name of the enumerator, and a phrase for people.
const char* to_string(ReachRejection reason);
const char* description(ReachRejection reason);

/// Whether an arm reaches a pose.
struct Reach {
  /// Positions of all moving joints of the robot, those of other joints as given; empty if the pose
  /// is not reached.
  Eigen::VectorXd positions;
  std::optional<ReachRejection> reason;  ///< none if the pose is reached
  /// Of `joint_limit`: index into the model's joints of the one that exceeds its limits most.
  std::optional<std::size_t> joint;
  double value = 0.0;  ///< too_far: distance from the first joint [m]; joint_limit: position of
                       ///< `joint`; else the error that remains [m or rad]
  double bound = 0.0;  ///< too_far: length of the arm [m]; joint_limit: the limit; else 0

  bool reached() const { return !reason; }
};

/// Whether the arm brings its tip to T_root_tip (in links[0]) while other joints stand at
/// `positions`. The solution is near the arm's joints in `positions`. Throws InputError if sizes
/// differ or a number is not finite.
Reach reach_pose(const RobotModel& model, const Arm& arm, const Eigen::Isometry3d& T_root_tip,
                 const Eigen::VectorXd& positions, const InverseKinematicsOptions& options = {});

/// The pose of the arm's tip, in the model's root, at which its gripper's tool is at T_world_tool.
Eigen::Isometry3d tip_of_tool(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                              const Eigen::Isometry3d& T_world_tool);

/// Whether the arm brings its gripper to a grasp, from the robot's home configuration.
Reach reach_grasp(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                  const Grasp& grasp, const InverseKinematicsOptions& options = {});

struct ReachabilityOptions {
  double spacing = 0.05;
  int directions = 8;
  int starts = 8;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("spacing", self.spacing, "m", above_up_to(0.0, 10.0), "distance of the grid's points");
    visit("directions", self.directions, "", between(1, 360),
          "closing directions from above, and directions of approach from the side");
    visit("starts", self.starts, "", between(1, 1e6),
          "joint vectors from which inverse kinematics starts for each pose");
  }
  void validate() const { check_fields(*this); }
};

/// What share of directions an arm reaches the points of a grid from, by x, then y, then z.
struct ReachabilityMap {
  Eigen::Vector3d first_world = Eigen::Vector3d::Zero();  ///< the grid's first point
  double spacing = 0.0;                                   ///< [m]
  std::array<int, 3> size{};                              ///< points along x, y and z
  /// Approach straight down: share of closing directions that are reached.
  std::vector<float> from_above;
  /// Approach along horizontal directions, fingers closing horizontally: share that is reached.
  std::vector<float> from_side;

  std::size_t index(int x, int y, int z) const;
  Eigen::Vector3d point_world(int x, int y, int z) const;
};

/// The reachability of the points of a grid in `volume_world` (z up; a plane if it has no height)
/// by the point between the finger tips. A gripper turned by 180° about the approach counts as the
/// same. Collisions are not considered. Throws InputError if the volume is empty or not finite, or
/// the grid has more than a million points.
ReachabilityMap reachability_map(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                                 const Eigen::AlignedBox3d& volume_world,
                                 const ReachabilityOptions& options = {});

}  // namespace symscene
