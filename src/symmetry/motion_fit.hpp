#pragma once

#include <span>

#include <Eigen/Geometry>

#include "surface_distance.hpp"
#include "symscene/core/geometry.hpp"

namespace symscene {

/// The motions of symmetries, as x' = linear · x + translation.
Eigen::Affine3d motion_of(const ReflectionPlane& plane);
Eigen::Affine3d motion_of(const RotationAxis& axis, double angle);

/// How samples of the surface are matched: with those of a grid, or with the nearest.
enum class Matching { coarse, exact };

/// The mean distance of moved samples from the surface. [m]
double mean_distance(const SurfaceDistance& surface, std::span<const Index> samples,
                     const Eigen::Affine3d& motion, Matching matching = Matching::exact);
/// For the worst of the angles. [m]
double mean_distance(const SurfaceDistance& surface, std::span<const Index> samples,
                     const RotationAxis& axis, std::span<const double> angles,
                     Matching matching = Matching::exact);

/// The share of moved samples that are farther than `distance` from the surface.
double share_beyond(const SurfaceDistance& surface, std::span<const Index> samples,
                    const Eigen::Affine3d& motion, double distance);

/// Fits a plane, or an axis for all of the angles, to a surface: moved samples are aligned with it
/// point to plane, by Gauss-Newton steps under Cauchy weights (Eqs. 3.3, 3.7).
ReflectionPlane fit_to(const SurfaceDistance& surface, std::span<const Index> samples,
                       const ReflectionPlane& start, Matching matching);
RotationAxis fit_to(const SurfaceDistance& surface, std::span<const Index> samples,
                    const RotationAxis& start, std::span<const double> angles, Matching matching);

}  // namespace symscene
