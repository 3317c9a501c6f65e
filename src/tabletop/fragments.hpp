#pragma once

#include <cstddef>
#include <vector>

#include "symscene/core/point_cloud.hpp"
#include "symscene/tabletop/tabletop_options.hpp"

namespace symscene {

/// How points are joined to fragments, and how many make one.
struct FragmentBounds {
  double link = 0.0;  ///< [m]
  std::size_t least = 0;
};

/// The bounds of the options, which are made for points one voxel apart, for points of a coarser
/// sensor or farther away.
FragmentBounds bounds_for(const Points& points, const TableCropOptions& options);

/// The fragment of each point: the points that links of at most this length connect. Fragments are
/// numbered by their first points.
std::vector<Index> fragments_of(const Points& points, double link);

/// The points in connected fragments that are not too small, ascending.
PointIndices points_in_fragments(const Points& points, const TableCropOptions& options);

}  // namespace symscene
