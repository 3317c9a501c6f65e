#include "collision_capsules.hpp"

#include <algorithm>
#include <numbers>

namespace symscene {
namespace {

/// Relative to the radius: numbers in files are rounded.
constexpr double same = 1e-3;

Capsule capsule_along(const Eigen::Isometry3d& T_link_shape, const Eigen::Vector3d& axis,
                      double half_length, double radius) {
  return {T_link_shape * (-half_length * axis), T_link_shape * (half_length * axis), radius};
}

/// The capsule of least volume along the longest edge that contains all corners.
Capsule bounding_capsule(const CollisionShape& box) {
  Eigen::Index longest = 0;
  const double half = 0.5 * box.size.maxCoeff(&longest);
  const double across_squared = 0.25 * box.size.squaredNorm() - half * half;
  const auto radius = [&](double s) { return std::sqrt((half - s) * (half - s) + across_squared); };
  const auto volume = [&](double s) {
    const double r = radius(s);
    return std::numbers::pi * r * r * (2.0 * s + 4.0 / 3.0 * r);
  };
  constexpr int steps = 100;
  double best = half;
  for (int i = 0; i < steps; ++i) {
    const double s = half * i / steps;
    if (volume(s) < volume(best)) best = s;
  }
  return capsule_along(box.T_link_shape, Eigen::Vector3d::Unit(longest), best, radius(best));
}

bool is_end_of(const Capsule& sphere, const Capsule& capsule) {
  const double tolerance = same * capsule.radius;
  const double distance =
      std::min((sphere.begin - capsule.begin).norm(), (sphere.begin - capsule.end).norm());
  return distance <= tolerance && std::abs(sphere.radius - capsule.radius) <= tolerance;
}

}  // namespace

std::vector<Capsule> collision_capsules(const std::vector<CollisionShape>& shapes) {
  std::vector<Capsule> capsules;
  for (const CollisionShape& shape : shapes) {
    if (shape.kind == CollisionKind::cylinder)
      capsules.push_back(capsule_along(shape.T_link_shape, Eigen::Vector3d::UnitZ(),
                                       0.5 * shape.size[1], shape.size[0]));
    else if (shape.kind == CollisionKind::box)
      capsules.push_back(bounding_capsule(shape));
  }
  for (const CollisionShape& shape : shapes) {
    if (shape.kind != CollisionKind::sphere) continue;
    const Capsule sphere{shape.T_link_shape.translation(), shape.T_link_shape.translation(),
                         shape.size[0]};
    if (std::none_of(capsules.begin(), capsules.end(),
                     [&](const Capsule& capsule) { return is_end_of(sphere, capsule); }))
      capsules.push_back(sphere);
  }
  return capsules;
}

}  // namespace symscene
