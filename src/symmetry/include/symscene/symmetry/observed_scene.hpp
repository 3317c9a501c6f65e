#pragma once

#include <optional>

#include "symscene/core/geometry.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/occupancy/distance_field.hpp"

namespace symscene {

/// The observed surroundings of an object. The referents must outlive this.
struct ObservedScene {
  const PointCloud& cloud;  ///< unit normals; the points of objects are indices into it
  const DistanceField& field;
  std::optional<Plane> table;
};

}  // namespace symscene
