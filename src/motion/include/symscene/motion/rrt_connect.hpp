#pragma once

#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "symscene/core/options.hpp"
#include "symscene/motion/joint_space.hpp"

namespace symscene {

struct RrtConnectOptions {
  double max_step = 0.7;
  double resolution = 0.02;
  int max_iterations = 5000;
  int shortcuts = 40;
  std::uint64_t seed = 0;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("max_step", self.max_step, "rad", above_up_to(0.0, 10.0),
          "longest edge of the trees, in the space of joints");
    visit("resolution", self.resolution, "rad", above_up_to(0.0, 1.0),
          "distance of the configurations at which an edge is checked, for validity that knows "
          "configurations only");
    visit("max_iterations", self.max_iterations, "", between(1, 1e7),
          "random configurations towards which the trees grow (Kuffner and LaValle 2000)");
    visit("shortcuts", self.shortcuts, "", between(0, 1e6),
          "tries to join two random points of the path by a straight line");
    visit("seed", self.seed, "", any_value(), "seed of the random configurations");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// What decides whether the robot may be somewhere. Both are called on configurations within the
/// limits, or beyond by full turns of continuous joints.
struct MotionValidity {
  /// What is wrong with a configuration, a phrase; empty if nothing is. Required.
  std::function<std::string(const Eigen::VectorXd&)> obstacle;
  /// Whether the straight motion between two valid configurations is valid. Without it,
  /// configurations at most `resolution` apart are looked at.
  std::function<bool(const Eigen::VectorXd&, const Eigen::VectorXd&)> is_free = {};
};

enum class PathStatus : std::uint8_t {
  found,
  invalid_start,  ///< in collision or outside the limits
  invalid_goal,   ///< all goals are
  no_path         ///< none within the budget
};
/// The name of the enumerator.
const char* to_string(PathStatus status);

/// A path of straight lines in the space of joints.
struct PathResult {
  PathStatus status = PathStatus::no_path;
  /// From the start to a goal, free of jumps: a continuous joint may pass ±π. Empty unless found.
  std::vector<Eigen::VectorXd> waypoints;
  std::size_t goal = 0;    ///< index of the goal that was reached
  std::string obstacle;    ///< what is wrong with the start, or with the first goal
  int iterations = 0;      ///< 0: a straight line was enough
  std::size_t checks = 0;  ///< configurations and motions that were looked at
};

/// A valid path from `start` to one of `goals`: a straight line to the nearest goal that has one,
/// else RRT-Connect (Kuffner and LaValle 2000), one tree from the start and one from all goals;
/// then shortcuts. Equal input gives equal bytes. Throws InputError if an option is invalid, sizes
/// differ, a number is not finite or there is no goal.
PathResult rrt_connect(const JointSpace& space, const Eigen::VectorXd& start,
                       const std::vector<Eigen::VectorXd>& goals, const MotionValidity& validity,
                       const RrtConnectOptions& options = {});

}  // namespace symscene
