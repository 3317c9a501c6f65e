#pragma once

#include <vector>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "symscene/core/types.hpp"

namespace symscene {

/// The moments whose pose is needed: the first, the last, and those whose pose differs from the one
/// before or after. Between them the pose stays or is interpolated. Poses that differ by less than
/// a tenth of a millimetre and a tenth of a milliradian are the same.
PointIndices kept_moments(const std::vector<Eigen::Isometry3d>& poses);

/// The way of a solid as the page reads it: kept moments, positions and unit quaternions (x, y, z,
/// w times 32767 as int16).
nlohmann::json track_payload(const std::vector<Eigen::Isometry3d>& poses);

}  // namespace symscene
