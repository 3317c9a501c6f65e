#pragma once

#include <array>
#include <span>
#include <vector>

#include "symscene/core/types.hpp"

#include <Eigen/Geometry>

namespace symscene {

/// Views at one angle from the vertical, evenly spaced around it.
struct ViewRing {
  double from_vertical = 0.0;  ///< [rad]
  int views = 1;
};

/// 34 views of a half sphere: 6 at 15° from the vertical, 12 at 35°, 16 at 60°.
constexpr std::array<ViewRing, 3> default_view_rings{
    {{radians(15.0), 6}, {radians(35.0), 12}, {radians(60.0), 16}}};

/// T_world_camera of the views of the rings about `target` at a distance of `radius` [m], those of
/// each ring from `first_azimuth` on [rad]. Throws InputError if the radius is not positive or a
/// ring has no view.
std::vector<Eigen::Isometry3d> views_on_sphere(const Eigen::Vector3d& target,
                                               const Eigen::Vector3d& up, double radius,
                                               std::span<const ViewRing> rings = default_view_rings,
                                               double first_azimuth = 0.0);

}  // namespace symscene
