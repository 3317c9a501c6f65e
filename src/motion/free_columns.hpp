#pragma once

#include <vector>

#include "symscene/core/geometry.hpp"
#include "symscene/occupancy/occupancy_grid.hpp"

namespace symscene {

/// Where an object that was not seen could stand. It rests on the table, so nothing of it lies
/// above space that was seen to be free, and it is no taller than the tallest seen surface: what is
/// hidden stands in the shadow of what hides it, and a camera above looks down along that shadow.
class FreeColumns {
 public:
  /// Columns of square section along the table's normal, over the cells of `frame`. `edge`: of a
  /// column. `tallest`: height of the highest seen surface above the table. [m]
  FreeColumns(const Plane& table, const VoxelFrame& frame, float edge, double tallest);

  /// A cube with this centre was seen to be free.
  void add_free(const Eigen::Vector3f& centre);
  /// Whether a hidden object could reach this point.
  bool may_hide(const Eigen::Vector3f& point) const;

 private:
  std::size_t column_at(const Eigen::Vector3f& point) const;

  Plane table_;
  double edge_;
  double tallest_;
  Eigen::Matrix<double, 2, 3> across_;  ///< two axes along the table
  Eigen::Vector2d least_ = Eigen::Vector2d::Zero();
  Eigen::Array2i size_ = Eigen::Array2i::Zero();
  std::vector<double> lowest_;  ///< height of the lowest free cube of each column [m]
};

}  // namespace symscene
