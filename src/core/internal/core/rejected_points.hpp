#pragma once

#include "symscene/core/point_cloud.hpp"
#include "symscene/core/scene.hpp"

namespace symscene {

/// The points of a rejected hypothesis that files and pages keep: at most 128, evenly spread.
inline PointIndices kept_points(const Rejection& rejection) {
  constexpr Index most = 128;
  PointIndices kept;
  for (const Index i : evenly_spread(static_cast<Index>(rejection.points.size()), most))
    kept.push_back(rejection.points[i]);
  return kept;
}

}  // namespace symscene
