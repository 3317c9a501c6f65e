#include "seen_empty_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace symscene {
namespace {

/// The corners of a box and what an axis sees of them.
struct CylinderAround {
  float low = 0.0F, high = 0.0F, radius = 0.0F;
};

CylinderAround cylinder_around(const Box& box, const RotationAxis& axis) {
  CylinderAround cylinder{std::numeric_limits<float>::max(), -std::numeric_limits<float>::max(),
                          0.0F};
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d corner((k & 1) != 0 ? box.max.x() : box.min.x(),
                                 (k & 2) != 0 ? box.max.y() : box.min.y(),
                                 (k & 4) != 0 ? box.max.z() : box.min.z());
    const auto height = static_cast<float>(axis.direction.dot(corner - axis.point));
    cylinder.low = std::min(cylinder.low, height);
    cylinder.high = std::max(cylinder.high, height);
    cylinder.radius = std::max(cylinder.radius, static_cast<float>(axis.distance(corner)));
  }
  return cylinder;
}

using CircleDirections = std::array<Eigen::Vector3f, 48>;

/// Unit vectors around an axis.
CircleDirections directions_around(const RotationAxis& axis) {
  const Eigen::Matrix<double, 3, 2> across = orthonormal_complement(axis.direction);
  CircleDirections directions;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(directions.size());
    directions[k] = (across * Eigen::Vector2d(std::cos(angle), std::sin(angle))).cast<float>();
  }
  return directions;
}

float greatest_depth(const DistanceField& field, const Eigen::Vector3f& centre, float radius,
                     const CircleDirections& directions) {
  float greatest = 0.0F;
  for (const Eigen::Vector3f& direction : directions)
    greatest = std::max(greatest, field.at(centre + radius * direction));
  return greatest;
}

}  // namespace

CircleDepths::CircleDepths(const RotationAxis& axis, const DistanceField& field, const Box& box)
    : point_(axis.point.cast<float>()), direction_(axis.direction.cast<float>()) {
  const CylinderAround cylinder = cylinder_around(box, axis);
  const float cell = field.frame.resolution;
  lowest_ = cylinder.low;
  inverse_cell_ = 1.0F / cell;
  heights_ = 1 + static_cast<int>((cylinder.high - cylinder.low) / cell);
  radii_ = 1 + static_cast<int>(cylinder.radius / cell);
  depths_.reserve(static_cast<std::size_t>(heights_) * static_cast<std::size_t>(radii_));
  const CircleDirections directions = directions_around(axis);
  for (int h = 0; h < heights_; ++h) {
    const float height = lowest_ + (static_cast<float>(h) + 0.5F) * cell;
    for (int r = 0; r < radii_; ++r) {
      depths_.push_back(greatest_depth(field, point_ + height * direction_,
                                       (static_cast<float>(r) + 0.5F) * cell, directions));
    }
  }
}

float CircleDepths::at(const Eigen::Vector3f& point) const {
  const Eigen::Vector3f q = point - point_;
  const float height = direction_.dot(q);
  const float radius = (q - height * direction_).norm();
  const int h = std::clamp(static_cast<int>((height - lowest_) * inverse_cell_), 0, heights_ - 1);
  const int r = std::clamp(static_cast<int>(radius * inverse_cell_), 0, radii_ - 1);
  return depths_[static_cast<std::size_t>(h) * static_cast<std::size_t>(radii_) +
                 static_cast<std::size_t>(r)];
}

SeenEmptySpace::SeenEmptySpace(const DistanceField& field, const std::vector<ObjectAxis>& axes,
                               std::vector<ReflectionPlane> planes, const Box& box)
    : field_(field), planes_(std::move(planes)) {
  for (const ObjectAxis& rotational : axes) circles_.emplace_back(rotational.axis, field, box);
}

float SeenEmptySpace::depth(const Eigen::Vector3f& point) const {
  const float half = 0.5F * field_.frame.resolution;
  const Eigen::Array3f first =
      (point - field_.frame.origin).array() * field_.inverse_resolution - 0.5F;
  const Eigen::Array3f t = first - first.floor();
  float depth = 0.0F;
  for (int k = 0; k < 8; ++k) {
    const bool x = (k & 1) != 0, y = (k & 2) != 0, z = (k & 4) != 0;
    const float weight =
        (x ? t.x() : 1.0F - t.x()) * (y ? t.y() : 1.0F - t.y()) * (z ? t.z() : 1.0F - t.z());
    const Eigen::Vector3f voxel(x ? half : -half, y ? half : -half, z ? half : -half);
    depth += weight * field_.at(point + voxel);
  }
  return depth;
}

float SeenEmptySpace::image_depth(const Eigen::Vector3f& point) const {
  float greatest = 0.0F;
  for (unsigned subset = 0; subset < 1U << planes_.size(); ++subset) {
    Eigen::Vector3d image = point.cast<double>();
    for (std::size_t k = 0; k < planes_.size(); ++k) {
      if ((subset >> k & 1U) != 0) image = planes_[k].reflect_point(image);
    }
    const Eigen::Vector3f at = image.cast<float>();
    greatest = std::max(greatest, field_.at(at));
    for (const CircleDepths& circle : circles_) greatest = std::max(greatest, circle.at(at));
  }
  return greatest;
}

}  // namespace symscene
