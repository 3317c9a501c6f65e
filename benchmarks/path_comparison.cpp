#include "path_comparison.hpp"

#include <algorithm>
#include <optional>

#include "core/random.hpp"
#include "path_oracle.hpp"
#include "stopwatch.hpp"
#include "symscene/motion/motion_validity.hpp"

namespace symscene::bench {
namespace {

constexpr double least_seconds = 0.05;  // for the oracle

/// None if many samples meet something: an arm may have nearly no room.
std::optional<Eigen::VectorXd> free_positions(const JointSpace& space, const ArmCollision& arm,
                                              Random& random) {
  constexpr int tries = 2000;
  for (int i = 0; i < tries; ++i) {
    const Eigen::VectorXd positions = space.sample(random);
    if (!arm.contact(positions)) return positions;
  }
  return std::nullopt;
}

/// Where the robot stands at home nothing can be hidden, as for picks.
std::vector<Capsule> capsules_at_home(const Robot& robot, const RobotArm& arm,
                                      const Gripper& gripper, const PickOptions& options) {
  const MotionObstacles nothing{GraspScene{}};
  return ArmCollision(robot, arm, &gripper, gripper.max_opening, nothing, robot.home,
                      options.collision)
      .capsules(arm_positions(arm.arm, robot.home));
}

void compare(const JointSpace& space, const MotionValidity& validity, const Eigen::VectorXd& start,
             const Eigen::VectorXd& goal, const RrtConnectOptions& options,
             PathComparison& comparison) {
  PathResult path;
  const Seconds time =
      seconds([&] { path = rrt_connect(space, start, {goal}, validity, options); });
  const bool found = path.status == PathStatus::found;
  const double ten_times = std::max(least_seconds, 10.0 * time.wall);
  const bool by_oracle = oracle_finds_path(space, start, goal, validity, ten_times);
  ++comparison.pairs;
  comparison.ours += found ? 1 : 0;
  comparison.oracle += by_oracle ? 1 : 0;
  comparison.oracle_alone += by_oracle && !found ? 1 : 0;
  comparison.seconds.push_back(time.wall);
}

}  // namespace

void compare_paths(const Robot& robot, const Gripper& gripper, const GraspScene& scene,
                   const PickOptions& options, std::uint64_t seed, int pairs,
                   PathComparison& comparison) {
  const RobotArm& arm = robot.grasping_arm();
  const MotionObstacles obstacles(scene, capsules_at_home(robot, arm, gripper, options),
                                  options.obstacles);
  const ArmCollision collision(robot, arm, &gripper, gripper.max_opening, obstacles, robot.home,
                               options.collision);
  const JointSpace space = joint_space(robot.model, arm.arm);
  const MotionValidity validity = motion_validity(collision);
  Random random(seed);
  for (int i = 0; i < pairs; ++i) {
    const auto start = free_positions(space, collision, random);
    const auto goal = free_positions(space, collision, random);
    if (start && goal) compare(space, validity, *start, *goal, options.rrt, comparison);
  }
}

}  // namespace symscene::bench
