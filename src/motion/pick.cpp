#include "symscene/motion/pick.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "checked_trajectory.hpp"
#include "pick_candidates.hpp"
#include "symscene/core/error.hpp"
#include "symscene/motion/motion_validity.hpp"
#include "symscene/motion/pick_survey.hpp"

namespace symscene {
namespace {

/// The capsules of the robot where it stands, in the world.
std::vector<Capsule> robot_at(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                              const Eigen::VectorXd& start, const PickOptions& options) {
  const MotionObstacles nothing{GraspScene{}};
  return ArmCollision(robot, arm, &gripper, gripper.max_opening, nothing, start, options.collision)
      .capsules(arm_positions(arm.arm, start));
}

/// Plans for one grasp after another.
class PickPlanner {
 public:
  PickPlanner(PickCandidates& candidates, const MotionLimits& limits,
              const MotionLimits& line_limits, const PickOptions& options)
      : candidates_(candidates), limits_(limits), line_limits_(line_limits), options_(options) {}

  /// The motion for a grasp; none, and `why`. Candidates that a straight line reaches are taken
  /// before others are looked at.
  std::optional<PickMotion> plan(const Eigen::VectorXd& start, const Grasp& grasp,
                                 StageTimer& timer, RejectedPick& why) const {
    const std::vector<HandPositions> positions =
        timer.time("grasp positions", [&] { return candidates_.positions(grasp, why); });
    std::vector<PickCandidate> found;
    std::array<std::optional<ArmCollision>, 2> holding;  // not turned, and turned
    for (const HandPositions& hand : positions) {
      auto candidate = timer.time("straight ways", [&] {
        std::optional<ArmCollision>& arm = holding.at(hand.is_turned ? 1 : 0);
        if (!arm) arm.emplace(candidates_.holding_arm(grasp, hand));
        return candidates_.candidate(grasp, hand, *arm, why);
      });
      if (!candidate) continue;
      const auto line = timer.time("path", [&] { return line_to(start, grasp, *candidate); });
      if (line) return timer.time("trajectory", [&] { return timed(grasp, *candidate, *line); });
      found.push_back(std::move(*candidate));
    }
    return found.empty() ? std::nullopt : plan_around(start, grasp, found, timer, why);
  }

 private:
  IgnoredObstacles at_target(const Grasp& grasp) const { return {-1, grasp.object}; }

  /// The straight line of the joints to a candidate, if it is free.
  std::optional<std::vector<Eigen::VectorXd>> line_to(const Eigen::VectorXd& start,
                                                      const Grasp& grasp,
                                                      const PickCandidate& candidate) const {
    const Eigen::VectorXd goal =
        start + candidates_.space().difference(start, candidate.approach.front());
    if (!candidates_.open_arm().is_free(start, goal, at_target(grasp))) return std::nullopt;
    return std::vector<Eigen::VectorXd>{start, goal};
  }

  std::optional<PickMotion> plan_around(const Eigen::VectorXd& start, const Grasp& grasp,
                                        const std::vector<PickCandidate>& found, StageTimer& timer,
                                        RejectedPick& why) const {
    const PathResult path = timer.time("path", [&] { return path_to(start, grasp, found); });
    if (path.status == PathStatus::found) {
      return timer.time("trajectory",
                        [&] { return timed(grasp, found[path.goal], path.waypoints); });
    }
    why.reason = PickRejection::no_path;
    why.detail = path.obstacle;
    return std::nullopt;
  }

  PathResult path_to(const Eigen::VectorXd& start, const Grasp& grasp,
                     const std::vector<PickCandidate>& found) const {
    std::vector<Eigen::VectorXd> goals;
    for (const PickCandidate& candidate : found) goals.push_back(candidate.approach.front());
    return rrt_connect(candidates_.space(), start, goals,
                       motion_validity(candidates_.open_arm(), at_target(grasp)), options_.rrt);
  }

  PickMotion timed(const Grasp& grasp, const PickCandidate& candidate,
                   const std::vector<Eigen::VectorXd>& path) const {
    const MotionValidity validity = motion_validity(candidates_.open_arm(), at_target(grasp));
    // Full turns that the path made go on in what follows it.
    const Eigen::VectorXd turns = path.back() - candidate.approach.front();
    TrajectoryOptions line = options_.trajectory;
    line.max_deviation = std::min(line.max_deviation, 0.002);
    return {0, checked_trajectory(path, limits_, options_.trajectory, validity.is_free),
            time_optimal_trajectory(turned(candidate.approach, turns), line_limits_, line),
            time_optimal_trajectory(turned(candidate.retreat, turns), line_limits_, line)};
  }

  static std::vector<Eigen::VectorXd> turned(std::vector<Eigen::VectorXd> way,
                                             const Eigen::VectorXd& turns) {
    for (Eigen::VectorXd& positions : way) positions += turns;
    return way;
  }

  PickCandidates& candidates_;
  const MotionLimits& limits_;
  const MotionLimits& line_limits_;
  const PickOptions& options_;
};

/// What the grasps of one call share: obstacles, limits and the start.
class PickSearch {
 public:
  /// References are kept.
  PickSearch(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
             const Eigen::VectorXd& start, const GraspScene& scene, const PickOptions& options)
      : obstacles_(timer_.time("obstacles",
                               [&] {
                                 gripper.validate();
                                 options.validate();
                                 return MotionObstacles(
                                     scene, robot_at(robot, arm, gripper, start, options),
                                     options.obstacles);
                               })),
        candidates_(robot, arm, gripper, start, scene, obstacles_, options),
        from_(arm_positions(arm.arm, start)),
        limits_(motion_limits(robot.model, arm.arm, options.speed)),
        line_limits_(motion_limits(robot.model, arm.arm, options.speed * options.line_speed)),
        planner_(candidates_, limits_, line_limits_, options) {}

  /// Why the arm cannot move at all; empty if it can.
  std::string start_contact() const {
    if (const auto met = candidates_.open_arm().contact(from_)) return describe(*met);
    return candidates_.space().joint_outside(from_) >= 0 ? "a joint is outside its limits" : "";
  }

  /// The motion for the grasp with this index; none, and the reason is added to `rejected`.
  std::optional<PickMotion> plan(std::size_t index, const Grasp& grasp,
                                 std::vector<RejectedPick>& rejected) {
    RejectedPick why{index, PickRejection::too_far, {}};
    std::optional<PickMotion> motion = planner_.plan(from_, grasp, timer_, why);
    if (motion)
      motion->grasp = index;
    else
      rejected.push_back(why);
    return motion;
  }

  std::vector<StageTime> timings() const {
    std::vector<StageTime> sums;
    for (const StageTime& run : timer_.stages()) add_to_sums(sums, run);
    return sums;
  }

 private:
  StageTimer timer_;
  MotionObstacles obstacles_;
  PickCandidates candidates_;
  Eigen::VectorXd from_;
  MotionLimits limits_, line_limits_;
  PickPlanner planner_;
};

}  // namespace

const char* to_string(PickRejection reason) {
  switch (reason) {
    case PickRejection::too_far:
      return "too_far";
    case PickRejection::unreachable:
      return "unreachable";
    case PickRejection::joint_limit:
      return "joint_limit";
    case PickRejection::line:
      return "line";
    case PickRejection::collision:
      return "collision";
    case PickRejection::no_path:
      return "no_path";
  }
  return "";
}

const char* description(PickRejection reason) {
  switch (reason) {
    case PickRejection::too_far:
      return "it is farther away than the arm is long";
    case PickRejection::unreachable:
      return "the arm does not reach it in that orientation";
    case PickRejection::joint_limit:
      return "a joint would leave its limits";
    case PickRejection::line:
      return "the arm cannot move straight to it and back";
    case PickRejection::collision:
      return "the arm would collide";
    case PickRejection::no_path:
      return "no path was found to it";
  }
  return "";
}

MotionLimits motion_limits(const RobotModel& model, const Arm& arm, double speed) {
  const auto joints = static_cast<Eigen::Index>(arm.positions.size());
  MotionLimits limits{Eigen::VectorXd(joints), Eigen::VectorXd(joints)};
  for (Eigen::Index i = 0; i < joints; ++i) {
    const std::size_t position = arm.positions[static_cast<std::size_t>(i)];
    const JointLimits& joint = model.joints[model.joint_of_position(position)].limits;
    limits.velocity[i] = speed * joint.velocity;
    limits.acceleration[i] = speed * speed * joint.acceleration;
  }
  return limits;
}

PickResult plan_pick(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                     const Eigen::VectorXd& start, const GraspScene& scene,
                     std::span<const Grasp> grasps, const PickOptions& options) {
  PickSearch search(robot, arm, gripper, start, scene, options);
  PickResult result;
  result.start_contact = search.start_contact();
  const std::size_t count = std::min(grasps.size(), static_cast<std::size_t>(options.max_grasps));
  for (std::size_t i = 0; i < count && result.start_contact.empty() && !result.motion; ++i)
    result.motion = search.plan(i, grasps[i], result.rejected);
  result.timings = search.timings();
  return result;
}

PickSurvey survey_picks(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                        const Eigen::VectorXd& start, const GraspScene& scene,
                        std::span<const Grasp> grasps, const PickOptions& options) {
  PickSearch search(robot, arm, gripper, start, scene, options);
  PickSurvey survey;
  survey.start_contact = search.start_contact();
  for (std::size_t i = 0; i < grasps.size() && survey.start_contact.empty(); ++i) {
    std::optional<PickMotion> motion = search.plan(i, grasps[i], survey.rejected);
    if (!motion) continue;
    survey.reached.push_back(i);
    if (!survey.motion) survey.motion = std::move(motion);
  }
  survey.timings = search.timings();
  return survey;
}

PickSurvey as_survey(PickResult result) {
  PickSurvey survey{std::move(result.motion),
                    {},
                    std::move(result.rejected),
                    std::move(result.start_contact),
                    std::move(result.timings)};
  if (survey.motion) survey.reached.push_back(survey.motion->grasp);
  return survey;
}

}  // namespace symscene
