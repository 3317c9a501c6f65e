#pragma once

#include <cstdint>
#include <vector>

#include "symscene/motion/pick.hpp"

namespace symscene::bench {

/// Paths of ours and of the oracle between the same configurations.
struct PathComparison {
  int pairs = 0;
  int ours = 0;    ///< paths that ours found
  int oracle = 0;  ///< paths that the oracle found in ten times the time
  int oracle_alone = 0;
  std::vector<double> seconds = {};  ///< wall time of ours
};

/// Adds `pairs` pairs of random positions of the arm that are free among the obstacles of a scene.
/// Pairs are left out where 2,000 random positions all meet something. Throws InputError without
/// OMPL if `pairs` is above 0.
void compare_paths(const Robot& robot, const Gripper& gripper, const GraspScene& scene,
                   const PickOptions& options, std::uint64_t seed, int pairs,
                   PathComparison& comparison);

}  // namespace symscene::bench
