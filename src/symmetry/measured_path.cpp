#include "measured_path.hpp"

#include <algorithm>

#include <Eigen/Eigenvalues>

#include "symscene/core/geometry.hpp"

namespace symscene {

MeasuredPath::MeasuredPath(const BoundaryNodes& nodes, PointIndices path)
    : nodes_(nodes), path_(std::move(path)), along_(path_.size(), 0.0) {
  for (std::size_t k = 1; k < path_.size(); ++k)
    along_[k] = along_[k - 1] + (position(k) - position(k - 1)).norm();
}

Eigen::Vector3d MeasuredPath::tangent(std::size_t k, double reach) const {
  std::size_t first = k, last = k;
  while (first > 0 && along_[k] - along_[first - 1] <= reach) --first;
  while (last + 1 < size() && along_[last + 1] - along_[k] <= reach) ++last;
  const double count = static_cast<double>(last - first) + 1.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t i = first; i <= last; ++i) mean += position(i) / count;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (std::size_t i = first; i <= last; ++i)
    scatter += (position(i) - mean) * (position(i) - mean).transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(2);
}

double MeasuredPath::turn(std::size_t k, double reach) const {
  const double before = std::min(reach, along_[k]);
  const double after = std::min(reach, length() - along_[k]);
  if (std::min(before, after) < reach / 2.0) return 0.0;
  return angle_between(position(k) - position_at(along_[k] - before),
                       position_at(along_[k] + after) - position(k));
}

Eigen::Vector3d MeasuredPath::direction_at_start(double reach) const {
  return (position(0) - position_at(std::min(reach, length()))).normalized();
}

Eigen::Vector3d MeasuredPath::direction_at_end(double reach) const {
  return (position(size() - 1) - position_at(std::max(length() - reach, 0.0))).normalized();
}

PointIndices MeasuredPath::part(std::size_t begin, std::size_t end) const {
  return {path_.begin() + static_cast<std::ptrdiff_t>(begin),
          path_.begin() + static_cast<std::ptrdiff_t>(end)};
}

Eigen::Vector3d MeasuredPath::position_at(double along) const {
  if (size() < 2) return position(0);
  const auto next = std::upper_bound(along_.begin() + 1, along_.end() - 1, along);
  const auto k = static_cast<std::size_t>(next - along_.begin());
  const double share = (along - along_[k - 1]) / (along_[k] - along_[k - 1]);
  return position(k - 1) + std::clamp(share, 0.0, 1.0) * (position(k) - position(k - 1));
}

}  // namespace symscene
