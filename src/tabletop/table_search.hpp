#pragma once

#include <optional>

#include "symscene/tabletop/table_scene.hpp"

namespace symscene {

/// Finds the table in the oriented points of a whole reconstruction and the objects on it. `up` is
/// the direction that the table faces, if it is known. Throws InputError if points have no normals.
TableScene find_table_scene(const PointCloud& cloud, const TableSceneOptions& options = {},
                            const std::optional<Eigen::Vector3d>& up = std::nullopt);

/// The same with a given table, whose normal may have any length. Throws InputError if the normal
/// is zero or the plane not finite.
TableScene table_scene_on(const PointCloud& cloud, const Plane& table,
                          const TableSceneOptions& options = {});

}  // namespace symscene
