#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "symscene/core/geometry.hpp"
#include "symscene/core/types.hpp"
#include "symscene/occupancy/distance_field.hpp"

/// Angles and distances of single points under a symmetry, in float: the inner loops of detection
/// and segmentation.
namespace symscene {

/// Arc sine and cosine of values that rounding may have put outside [−1, 1]. [rad]
inline float safe_asin(float sine) { return std::asin(std::clamp(sine, -1.0F, 1.0F)); }
inline float safe_acos(float cosine) { return std::acos(std::clamp(cosine, -1.0F, 1.0F)); }

/// The number of rotations over which a point is checked against free space (Eq. 4.3).
constexpr int occlusion_rotations = 12;

/// Residuals of points under one rotation axis, before their ramps.
class AxisResiduals {
 public:
  explicit AxisResiduals(const RotationAxis& axis)
      : point_(axis.point.cast<float>()), direction_(axis.direction.cast<float>()) {
    for (std::size_t i = 0; i < rotations_.size(); ++i) {
      const double angle =
          2.0 * std::numbers::pi * static_cast<double>(i + 1) / occlusion_rotations;
      rotations_[i] = axis.rotation(angle).cast<float>();
    }
  }

  /// The angle between the normal and the plane through the axis and the point (Fig. 3.4). [0, π/2]
  /// rad
  float plane_angle(const Eigen::Vector3f& p, const Eigen::Vector3f& n) const {
    const Eigen::Vector3f across = direction_.cross(p - point_);
    const float length = across.norm();
    return length > 0.0F ? std::abs(safe_asin(n.dot(across) / length)) : 0.0F;
  }

  /// The angle between the normal and the axis. [0, π/2] rad
  float axis_angle(const Eigen::Vector3f& n) const {
    return safe_acos(std::abs(n.dot(direction_)));
  }

  /// The greatest distance into free space over all rotations of the point (Eq. 4.3, before its
  /// ramp). [m]
  float free_distance(const Eigen::Vector3f& p, const DistanceField& field) const {
    const Eigen::Vector3f offset = p - point_;
    float farthest = 0.0F;
    for (const Eigen::Matrix3f& rotation : rotations_) {
      farthest = std::max(farthest, field.at(point_ + rotation * offset));
    }
    return farthest;
  }

 private:
  Eigen::Vector3f point_;
  Eigen::Vector3f direction_;
  std::array<Eigen::Matrix3f, occlusion_rotations> rotations_;
};

/// Points and normals under one reflection plane.
class PlaneReflector {
 public:
  explicit PlaneReflector(const ReflectionPlane& plane)
      : normal_(plane.normal.cast<float>()),
        offset_(static_cast<float>(plane.normal.dot(plane.point))) {}

  const Eigen::Vector3f& normal() const { return normal_; }
  float signed_distance(const Eigen::Vector3f& p) const { return normal_.dot(p) - offset_; }
  Eigen::Vector3f point(const Eigen::Vector3f& p) const {
    return p - 2.0F * signed_distance(p) * normal_;
  }
  Eigen::Vector3f direction(const Eigen::Vector3f& d) const {
    return d - 2.0F * normal_.dot(d) * normal_;
  }

 private:
  Eigen::Vector3f normal_;
  float offset_;
};

}  // namespace symscene
