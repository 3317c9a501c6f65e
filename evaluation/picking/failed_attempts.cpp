#include "failed_attempts.hpp"

#include <algorithm>

namespace symscene {

int FailedAttempts::at(const Eigen::Vector3d& point) const {
  return static_cast<int>(std::count_if(points_.begin(), points_.end(), [&](const auto& failed) {
    return (failed - point).norm() <= radius_;
  }));
}

int FailedAttempts::in(const Box& box) const {
  return static_cast<int>(std::count_if(points_.begin(), points_.end(), [&](const auto& failed) {
    const Eigen::Vector3d nearest =
        failed.cwiseMax(box.min.cast<double>()).cwiseMin(box.max.cast<double>());
    return (failed - nearest).norm() <= radius_;
  }));
}

}  // namespace symscene
