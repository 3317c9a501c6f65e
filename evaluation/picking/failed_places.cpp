#include "failed_places.hpp"

#include <algorithm>

namespace symscene {

int FailedPlaces::failures_at(const Eigen::Vector3d& point) const {
  return static_cast<int>(std::count_if(points_.begin(), points_.end(), [&](const auto& failed) {
    return (failed - point).norm() <= radius_;
  }));
}

}  // namespace symscene
