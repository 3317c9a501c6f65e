#include "free_columns.hpp"

#include <algorithm>
#include <limits>

namespace symscene {

FreeColumns::FreeColumns(const Plane& table, const VoxelFrame& frame, float edge, double tallest)
    : table_(table), edge_(edge), tallest_(tallest) {
  const Eigen::Vector3d first = table.normal.unitOrthogonal();
  across_ << first.transpose(), table.normal.cross(first).transpose();
  Eigen::AlignedBox2d area;
  const Eigen::Vector3d extent = frame.resolution * frame.size.cast<double>();
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Array3d share(corner & 1, corner >> 1 & 1, corner >> 2);
    area.extend(across_ * (frame.origin.cast<double>() + (share * extent.array()).matrix()));
  }
  least_ = area.min();
  size_ = (area.sizes() / edge_).array().floor().cast<int>() + 1;
  lowest_.assign(static_cast<std::size_t>(size_.prod()), std::numeric_limits<double>::infinity());
}

std::size_t FreeColumns::column_at(const Eigen::Vector3f& point) const {
  const Eigen::Array2i column = ((across_ * point.cast<double>() - least_) / edge_)
                                    .array()
                                    .floor()
                                    .cast<int>()
                                    .max(0)
                                    .min(size_ - 1);
  return static_cast<std::size_t>(column.y()) * static_cast<std::size_t>(size_.x()) +
         static_cast<std::size_t>(column.x());
}

void FreeColumns::add_free(const Eigen::Vector3f& centre) {
  const double height = table_.signed_distance(centre.cast<double>());
  // Cubes that the table cuts say nothing of what stands on it.
  if (height < 0.5 * edge_) return;
  double& lowest = lowest_[column_at(centre)];
  lowest = std::min(lowest, height);
}

bool FreeColumns::may_hide(const Eigen::Vector3f& point) const {
  const double height = table_.signed_distance(point.cast<double>());
  return height <= tallest_ && height < lowest_[column_at(point)];
}

}  // namespace symscene
