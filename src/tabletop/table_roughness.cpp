#include "table_roughness.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/median.hpp"

namespace symscene {
namespace {

constexpr double deviation_of_median = 1.4826;  // of absolute values that are normally distributed

}  // namespace

TableRoughness::TableRoughness(const PointCloud& cloud, const BentPlane& surface,
                               const ConvexOutline& outline, double depth,
                               const TableCropOptions& options)
    : cells_across_(options.roughness_cells) {
  if (outline.corners().empty()) return;
  Eigen::Vector2d last = corner_ = outline.corners().front();
  for (const Eigen::Vector2d& corner : outline.corners()) {
    corner_ = corner_.cwiseMin(corner);
    last = last.cwiseMax(corner);
  }
  edge_ = std::max((last - corner_).maxCoeff() / cells_across_, 1e-6);
  std::vector<std::vector<double>> depths(static_cast<std::size_t>(cells_across_ * cells_across_));
  for (Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d point = cloud.position(i).cast<double>();
    const double height = surface.height(point);
    if (!(height < 0.0 && height > -depth)) continue;
    const Eigen::Vector2d within = surface.frame().within(point);
    if (outline.distance(within) < 0.0) depths[cell_of(within)].push_back(-height);
  }
  deviations_.resize(depths.size(), 0.0);
  for (std::size_t k = 0; k < depths.size(); ++k) {
    if (depths[k].size() >= static_cast<std::size_t>(options.min_roughness_points))
      deviations_[k] = deviation_of_median * *median(std::move(depths[k]));
  }
}

std::size_t TableRoughness::cell_of(const Eigen::Vector2d& within) const {
  const Eigen::Vector2d cell =
      ((within - corner_) / edge_).array().floor().max(0.0).min(cells_across_ - 1.0);
  return static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(cells_across_) +
         static_cast<std::size_t>(cell.x());
}

double TableRoughness::at(const Eigen::Vector2d& within) const {
  return deviations_.empty() ? 0.0 : deviations_[cell_of(within)];
}

}  // namespace symscene
