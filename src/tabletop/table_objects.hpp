#pragma once

#include "symscene/tabletop/table_scene.hpp"

namespace symscene {

/// The planes of a scene, found in some of its points.
struct FoundPlanes {
  const PointCloud& searched;  ///< the cloud of their inliers
  const SupportPlane& table;
  std::vector<SupportPlane> walls;  ///< planes too large to be faces of objects
};

/// The points above the table and inside its outline, thinned to one per voxel, without stray
/// fragments. A connected fragment is kept or dropped whole: it is kept if at least half of its
/// points are inside the outline. Points of walls are left out.
TableObjects objects_on(const PointCloud& cloud, const FoundPlanes& planes,
                        const TableSceneOptions& options);

}  // namespace symscene
