#pragma once

#include <vector>

#include "bent_plane.hpp"
#include "symscene/tabletop/tabletop_options.hpp"

namespace symscene {

/// How rough the measured surface of a table is from place to place. Where a sensor is far away its
/// noise can be larger than small objects. Objects only stand above a table, so the roughness is
/// that of the points below it.
class TableRoughness {
 public:
  /// From the points of the cloud that are inside the outline and at most `depth` [m] below.
  TableRoughness(const PointCloud& cloud, const BentPlane& surface, const ConvexOutline& outline,
                 double depth, const TableCropOptions& options);

  /// The standard deviation of the table's points around a place on it; 0 where too few were seen.
  /// [m]
  double at(const Eigen::Vector2d& within) const;

 private:
  std::size_t cell_of(const Eigen::Vector2d& within) const;

  int cells_across_;  ///< of the longer side of the outline's bounding box
  Eigen::Vector2d corner_ = Eigen::Vector2d::Zero();
  double edge_ = 1.0;  ///< of a cell [m]
  std::vector<double> deviations_;
};

}  // namespace symscene
