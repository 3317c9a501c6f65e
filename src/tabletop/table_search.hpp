#pragma once

#include "symscene/tabletop/table_scene.hpp"

namespace symscene {

/// Finds the table in the oriented points of a whole reconstruction and the objects on it. If what
/// faces the known `up` carries no objects or may be a face of one, the search is repeated without
/// `up`. A given table may have a normal of any length and of either sign. Throws InputError if
/// points have no normals, or a given plane has no points or a normal that is zero or not finite.
TableScene find_table_scene(const PointCloud& cloud, const TableSceneOptions& options = {},
                            const TablePrior& known = {});

}  // namespace symscene
