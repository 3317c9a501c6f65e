#include "grasping/nearest_owner.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "core/parallel.hpp"

namespace symscene {

NearestOwner::NearestOwner(const Eigen::Array3i& size, int owners)
    : size_(size),
      owners_(owners),
      claims_(Eigen::ArrayXd::Constant(size.cast<Eigen::Index>().prod(),
                                       std::numeric_limits<double>::infinity())) {}

void NearestOwner::claim(const Eigen::Array3i& voxel, int owner) {
  double& claim = claims_[row_begin(voxel.y(), voxel.z()) + voxel.x()];
  claim = std::min(claim, static_cast<double>(owner));
}

Eigen::ArrayXd NearestOwner::least_along(int axis, int radius, const Eigen::ArrayXd& values) const {
  Eigen::ArrayXd least(values.size());
  const auto row_at = [&](Eigen::Index y, Eigen::Index z) {
    return values.segment(row_begin(y, z), size_.x());
  };
  const auto least_of_row = [&](Eigen::Index y, Eigen::Index z) {
    auto row = least.segment(row_begin(y, z), size_.x());
    row = row_at(y, z);
    for (Eigen::Index step = 1; step <= std::min(radius, size_[axis] - 1); ++step) {
      const double further = owners_ * static_cast<double>(step * step);
      const Eigen::Index rest = size_.x() - step;
      const Eigen::Index at = axis == 1 ? y : z;
      if (axis == 0) {
        row.head(rest) = row.head(rest).min(row_at(y, z).tail(rest) + further);
        row.tail(rest) = row.tail(rest).min(row_at(y, z).head(rest) + further);
        continue;
      }
      for (const Eigen::Index other : {at - step, at + step}) {
        if (other >= 0 && other < size_[axis])
          row = row.min((axis == 1 ? row_at(other, z) : row_at(y, other)) + further);
      }
    }
  };
  parallel_for_each(static_cast<std::size_t>(size_.z()), [&](std::size_t z) {
    for (Eigen::Index y = 0; y < size_.y(); ++y) least_of_row(y, static_cast<Eigen::Index>(z));
  });
  return least;
}

std::vector<NearestOwner::Claim> NearestOwner::nearest(int radius) const {
  Eigen::ArrayXd least = claims_;
  for (int axis = 0; axis < 3; ++axis) least = least_along(axis, radius, least);
  const double farthest = owners_ * static_cast<double>(radius) * radius + owners_ - 1.0;
  const auto count = static_cast<std::int64_t>(owners_);
  std::vector<Claim> nearest(static_cast<std::size_t>(least.size()));
  std::transform(least.begin(), least.end(), nearest.begin(), [&](double value) {
    if (!(value <= farthest)) return Claim{};
    const auto whole = static_cast<std::int64_t>(value);
    return Claim{static_cast<int>(whole % count), static_cast<int>(whole / count)};
  });
  return nearest;
}

}  // namespace symscene
