#include "visibility.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/median.hpp"
#include "core/spacing.hpp"

namespace symscene {
namespace {

constexpr float min_cell = 1e-4F;  // so that the numbers of cells fit

float median_distance(const Points& points, const Eigen::Vector3f& viewpoint) {
  std::vector<double> distances;
  distances.reserve(static_cast<std::size_t>(points.rows()));
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    distances.push_back(double{(points.row(i).transpose() - viewpoint).norm()});
  return static_cast<float>(median(std::move(distances)).value_or(0.0));
}

}  // namespace

Visibility::Visibility(const Points& points, const Eigen::Vector3f& viewpoint, float cell_spacings)
    : viewpoint_(viewpoint), spacing_(median_spacing(points).value_or(0.0F)) {
  const float distance = median_distance(points, viewpoint);
  if (distance > 0.0F) cell_ = std::max(cell_spacings * spacing_ / distance, min_cell);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3f ray = points.row(i).transpose() - viewpoint_;
    const auto [nearest, is_new] = nearest_.try_emplace(cell_of(ray), ray.norm());
    if (!is_new) nearest->second = std::min(nearest->second, ray.norm());
  }
}

PointIndices Visibility::seen(const Points& points, float spacings) const {
  PointIndices seen;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3f ray = points.row(i).transpose() - viewpoint_;
    const auto nearest = nearest_.find(cell_of(ray));
    if (nearest == nearest_.end() || ray.norm() <= nearest->second + spacings * spacing_)
      seen.push_back(static_cast<Index>(i));
  }
  return seen;
}

/// The cell of a face of a cube around the viewpoint.
std::uint64_t Visibility::cell_of(const Eigen::Vector3f& ray) const {
  Eigen::Index axis = 0;
  const float longest = ray.cwiseAbs().maxCoeff(&axis);
  if (!(longest > 0.0F)) return 0;
  const auto face = static_cast<std::uint64_t>(2 * axis + (ray[axis] > 0.0F ? 1 : 0));
  const auto along = [&](Eigen::Index other) {
    return static_cast<std::uint64_t>((ray[other] / longest + 1.0F) / cell_);
  };
  return (face << 60U) | (along((axis + 1) % 3) << 30U) | along((axis + 2) % 3);
}

}  // namespace symscene
