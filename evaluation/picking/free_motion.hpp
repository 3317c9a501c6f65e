#pragma once

#include <optional>
#include <string>
#include <vector>

#include "symscene/motion/arm_collision.hpp"
#include "symscene/motion/rrt_connect.hpp"
#include "symscene/motion/trajectory.hpp"

namespace symscene {

/// What a motion is planned with. References are kept.
struct MotionPlanner {
  const ArmCollision& collision;
  const JointSpace& space;
  const MotionLimits& limits;
  const RrtConnectOptions& rrt;
  IgnoredObstacles ignored = {};
};

/// A motion to one of several goals, or why there is none.
struct FreeMotion {
  std::optional<TimedPath> path;
  std::string obstacle = {};                    ///< why there is no path
  std::vector<Eigen::VectorXd> waypoints = {};  ///< of the path, before its corners are rounded
};

/// A free motion from `start` to one of `goals`, positions of the arm's joints, at rest at both
/// ends.
FreeMotion plan_free_motion(const MotionPlanner& planner, const Eigen::VectorXd& start,
                            const std::vector<Eigen::VectorXd>& goals);

/// The fastest motion along a free path. Its corners are rounded if the arcs are free too, else the
/// arm stops there.
TimedPath timed_motion(const MotionPlanner& planner, const std::vector<Eigen::VectorXd>& path);

/// Limits at which the same path takes `factor` times as long.
MotionLimits slowed(const MotionLimits& limits, double factor);

}  // namespace symscene
