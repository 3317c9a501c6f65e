#pragma once

#include <algorithm>

#include "symscene/core/types.hpp"

namespace symscene {

/// Of points from one place. In this order the compiler uses vector instructions. [m²]
inline Eigen::ArrayXf squared_distances(const Points& points, const Eigen::Vector3f& from) {
  return (points.col(0).array() - from.x()).square() +
         ((points.col(1).array() - from.y()).square() +
          (points.col(2).array() - from.z()).square());
}

/// The index of the first value that is the least, or the greatest. Eigen's own search for an index
/// does not use vector instructions.
inline Eigen::Index first_of(const Eigen::ArrayXf& values, float extreme) {
  return std::find(values.begin(), values.end(), extreme) - values.begin();
}

}  // namespace symscene
