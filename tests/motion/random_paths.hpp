#pragma once

#include <vector>

#include "core/random.hpp"
#include "symscene/motion/trajectory.hpp"

namespace symscene::testing {

/// A path with limits for its joints.
struct RandomPath {
  std::vector<Eigen::VectorXd> waypoints;
  MotionLimits limits;
};

inline Eigen::VectorXd random_vector(Random& random, Eigen::Index joints, double low, double high) {
  Eigen::VectorXd values(joints);
  for (double& value : values) value = random.uniform(low, high);
  return values;
}

/// Some paths move a few joints only, repeat waypoints, turn back or go straight on: there the
/// known methods fail.
inline RandomPath random_path(std::uint64_t seed, int most_waypoints = 10) {
  Random random(seed);
  const auto joints = static_cast<Eigen::Index>(1 + random.below(8));
  const int count =
      2 + static_cast<int>(random.below(static_cast<std::uint32_t>(most_waypoints - 1)));
  RandomPath path;
  path.waypoints.push_back(random_vector(random, joints, -2.0, 2.0));
  while (static_cast<int>(path.waypoints.size()) < count) {
    const Eigen::VectorXd& last = path.waypoints.back();
    Eigen::VectorXd step = random_vector(random, joints, -1.5, 1.5);
    if (random.chance(0.3)) step *= 0.02;
    for (double& value : step) {
      if (random.chance(0.25)) value = 0.0;
    }
    const std::size_t n = path.waypoints.size();
    if (n > 1 && random.chance(0.1)) step = -0.5 * (last - path.waypoints[n - 2]);
    if (n > 1 && random.chance(0.1)) step = last - path.waypoints[n - 2];
    path.waypoints.emplace_back(last + step);
  }
  path.limits.velocity = random_vector(random, joints, 0.5, 8.0);
  path.limits.acceleration = random_vector(random, joints, 1.0, 40.0);
  return path;
}

}  // namespace symscene::testing
