#pragma once

#include <cstdint>
#include <unordered_map>

#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// Which points of a cloud a viewpoint sees: those that are not behind others, as far as the
/// spacing of the points tells.
class Visibility {
 public:
  /// Points in one cell of directions, so many spacings wide, can hide each other.
  Visibility(const Points& points, const Eigen::Vector3f& viewpoint, float cell_spacings);

  /// The points of the cloud that are not more than so many spacings behind the nearest point of
  /// their direction, ascending.
  PointIndices seen(const Points& points, float spacings) const;

 private:
  std::uint64_t cell_of(const Eigen::Vector3f& ray) const;

  Eigen::Vector3f viewpoint_;
  float spacing_;      ///< median distance between neighbouring points [m]
  float cell_ = 1.0F;  ///< edge of the cells of directions, as a tangent
  std::unordered_map<std::uint64_t, float> nearest_;  ///< distance by cell [m]
};

}  // namespace symscene
