#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "symscene/core/error.hpp"
#include "symscene/core/geometry.hpp"
#include "symscene/core/types.hpp"
#include "symscene/occupancy/distance_field.hpp"

/// How well single points agree with a symmetry: the inner loops of detection and segmentation, in
/// float.
namespace symscene {

/// The least and the greatest value between which a score runs from 0 to 1.
struct ScoreRange {
  double min = 0.0;
  double max = 1.0;

  float operator()(float value) const {
    return ramp(value, static_cast<float>(min), static_cast<float>(max));
  }
};

/// Throws InputError if a range that detection and cuts share, of angles or of occlusion, is empty
/// or begins below 0.
template <class Options>
void require_score_ranges(const Options& options) {
  require_option(options.min_angle >= 0.0 && options.min_angle < options.max_angle, "max_angle",
                 "an angle above min_angle", options.max_angle);
  require_option(options.min_occlusion >= 0.0 && options.min_occlusion < options.max_occlusion,
                 "max_occlusion", "a distance above min_occlusion", options.max_occlusion);
}

/// The angle whose sine is `sine`, which rounding may have put outside [−1, 1]. [rad]
inline float safe_asin(float sine) { return std::asin(std::clamp(sine, -1.0F, 1.0F)); }
inline float safe_acos(float cosine) { return std::acos(std::clamp(cosine, -1.0F, 1.0F)); }

/// The number of rotations over which a point is checked against free space (Eq. 4.3).
constexpr int occlusion_rotations = 12;

/// Point scores under one rotation axis.
class AxisScorer {
 public:
  explicit AxisScorer(const RotationAxis& axis)
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

  /// The farthest that the rotated point gets from where an object can be (Eq. 4.3, before its
  /// range). [m]
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
