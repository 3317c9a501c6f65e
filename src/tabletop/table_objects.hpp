#pragma once

#include "symscene/tabletop/table_scene.hpp"

namespace symscene {

/// The points above the table and inside its outline, thinned to one per voxel, without stray
/// fragments. A connected fragment is kept or dropped whole: it is kept if at least half of its
/// points are inside the outline. Points of `walls` are left out.
TableObjects objects_on(const PointCloud& cloud, const SupportPlane& table,
                        const std::vector<SupportPlane>& walls, const TableCropOptions& options);

/// The points in connected fragments that are not too small, ascending.
PointIndices points_in_fragments(const Points& points, const TableCropOptions& options);

}  // namespace symscene
