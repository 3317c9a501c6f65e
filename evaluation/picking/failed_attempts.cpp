#include "failed_attempts.hpp"

#include <algorithm>

#include <Eigen/Geometry>

namespace symscene {

int FailedAttempts::at(const Eigen::Vector3d& point) const {
  return static_cast<int>(std::count_if(points_.begin(), points_.end(), [&](const auto& failed) {
    return (failed - point).norm() <= radius_;
  }));
}

int FailedAttempts::in(const Box& box) const {
  const Eigen::AlignedBox3d object(box.min.cast<double>(), box.max.cast<double>());
  return static_cast<int>(std::count_if(points_.begin(), points_.end(), [&](const auto& failed) {
    return object.exteriorDistance(failed) <= radius_;
  }));
}

}  // namespace symscene
