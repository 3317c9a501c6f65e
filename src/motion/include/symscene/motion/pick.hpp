#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "symscene/core/grasp.hpp"
#include "symscene/core/joint_trajectory.hpp"
#include "symscene/core/stage_timer.hpp"
#include "symscene/grasping/planner.hpp"
#include "symscene/motion/arm_collision.hpp"
#include "symscene/motion/rrt_connect.hpp"
#include "symscene/motion/trajectory.hpp"

namespace symscene {

struct PickOptions {
  double line_step = 0.01;
  double max_jump = 0.3;
  int solutions = 6;
  int max_grasps = 100;
  double speed = 1.0;
  double line_speed = 0.3;
  MotionObstacleOptions obstacles;
  ArmCollisionOptions collision;
  RrtConnectOptions rrt{.max_iterations = 500};
  TrajectoryOptions trajectory;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("line_step", self.line_step, "m", between(1e-3, 0.1),
          "distance of the poses on straight ways at which joint positions are computed");
    visit("max_jump", self.max_jump, "rad", above_up_to(0.0, 3.2),
          "greatest change of a joint between two of these poses");
    visit("solutions", self.solutions, "", between(1, 100),
          "joint positions that are tried for a grasp");
    visit("max_grasps", self.max_grasps, "", between(1, 1e6), "grasps that are tried");
    visit("speed", self.speed, "", above_up_to(0.0, 1.0),
          "share of the limits of velocity that is used; of acceleration its square");
    visit("line_speed", self.line_speed, "", above_up_to(0.0, 1.0),
          "the same on straight ways near objects");
    visit("obstacles", self.obstacles);
    visit("collision", self.collision);
    visit("rrt", self.rrt);
    visit("trajectory", self.trajectory);
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// Why a grasp was not taken.
enum class PickRejection : std::uint8_t {
  too_far,      ///< beyond the length of the arm
  unreachable,  ///< no joint positions for that pose, even without limits
  joint_limit,  ///< only with joints outside their limits
  line,         ///< joints jump or end on the straight way to the grasp or back
  collision,    ///< in all of its joint positions, or on the straight ways
  no_path       ///< none was found to the start of the straight way
};
constexpr std::size_t pick_rejections = 6;
/// The name of the enumerator, and a phrase for people.
const char* to_string(PickRejection reason);
const char* description(PickRejection reason);

/// A grasp that was not taken.
struct RejectedPick {
  std::size_t grasp = 0;  ///< index into the grasps
  PickRejection reason = PickRejection::unreachable;
  std::string detail;  ///< of a collision: what meets what
};

/// Motions of the arm's joints that pick an object. Between approach and retreat the gripper
/// closes.
struct PickMotion {
  std::size_t grasp = 0;   ///< index into the grasps
  TimedPath to_pre_grasp;  ///< from the current positions to before the object
  TimedPath approach;      ///< straight to the grasp
  TimedPath retreat;       ///< straight away with the object
};

struct PickResult {
  std::optional<PickMotion> motion;    ///< none if no grasp can be taken
  std::vector<RejectedPick> rejected;  ///< in the order of the grasps
  std::string start_contact;           ///< why the arm cannot move at all: what it meets already
  std::vector<StageTime> timings;
};

/// Motions for the first of `grasps`, best first, that the arm reaches without collision: joint
/// positions for the grasp by inverse kinematics, a straight way of the gripper's approach_distance
/// to it and of retreat_distance back (backwards if the approach is steep, else upwards), a
/// straight line of the joints or else a path by RRT-Connect to its start, and the fastest times
/// within the limits of the joints. `start`: positions of all moving joints. A parallel gripper may
/// be turned by half a turn. Throws InputError if an option, the gripper or a limit is invalid, or
/// sizes differ.
PickResult plan_pick(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                     const Eigen::VectorXd& start, const GraspScene& scene,
                     std::span<const Grasp> grasps, const PickOptions& options = {});

/// The motions as one trajectory of the arm's joints, with a pause at the grasp while the gripper
/// closes to `opening`. `period`: of the points. [s, m]
JointTrajectory pick_trajectory(const PickMotion& motion, const RobotModel& model, const Arm& arm,
                                const Gripper& gripper, double opening, double period = 0.01,
                                double pause = 1.0);

/// The limits of an arm's joints times a share of the speed.
MotionLimits motion_limits(const RobotModel& model, const Arm& arm, double speed = 1.0);

}  // namespace symscene
