#pragma once

#include <vector>

#include "symscene/core/scene.hpp"
#include "symscene/occupancy/distance_field.hpp"

namespace symscene {

/// How far inside observed free space a circle about an axis reaches, by height and radius.
class CircleDepths {
 public:
  /// For circles through the box.
  CircleDepths(const RotationAxis& axis, const DistanceField& field, const Box& box);

  /// The largest depth on the circle through a point. [m]
  float at(const Eigen::Vector3f& point) const;

 private:
  Eigen::Vector3f point_, direction_;  ///< of the axis
  float lowest_ = 0.0F;                ///< height along the axis of the first cell [m]
  float inverse_cell_ = 1.0F;          ///< [1/m]
  int heights_ = 0, radii_ = 0;        ///< cells
  std::vector<float> depths_;          ///< radii running fastest [m]
};

/// Space that was seen empty, and space that is as empty by the symmetries of an object: where one
/// image of a point was seen empty, all of them are outside the object.
class SeenEmptySpace {
 public:
  /// `box` holds the object. Refers to `field`.
  SeenEmptySpace(const DistanceField& field, const std::vector<ObjectAxis>& axes,
                 std::vector<ReflectionPlane> planes, const Box& box);

  /// How far inside observed free space a point lies, interpolated between voxels. [m]
  float depth(const Eigen::Vector3f& point) const;

  /// The largest depth among the images of a point under the symmetries. [m]
  float image_depth(const Eigen::Vector3f& point) const;

  bool has_symmetries() const { return !circles_.empty() || !planes_.empty(); }

 private:
  const DistanceField& field_;
  std::vector<CircleDepths> circles_;  ///< one per axis
  std::vector<ReflectionPlane> planes_;
};

}  // namespace symscene
