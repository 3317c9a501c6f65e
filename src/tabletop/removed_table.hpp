#pragma once

#include "symscene/tabletop/table_scene.hpp"

namespace symscene {

/// Extends the outline of a given table below what stands on it if this covers more of the plane
/// than the points of the table do: these were removed from the cloud. What reaches below the
/// plane or begins high above it does not stand on it.
void extend_outline_below_objects(SupportPlane& table, const PointCloud& cloud,
                                  const TableSceneOptions& options);

}  // namespace symscene
