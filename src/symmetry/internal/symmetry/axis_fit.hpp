#pragma once

#include <vector>

#include "symmetry/fit_status.hpp"
#include "symscene/core/geometry.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/symmetry/axis_fit_options.hpp"

namespace symscene {

struct AxisFit {
  RotationAxis axis;
  double cost = 0.0;  ///< mean robust cost in [0, 1]; comparable between fits of the same points
  FitStatus status = FitStatus::too_few_points;
};

/// The axis near `initial` in whose planes the points' normals lie (section 3.5.2): minimises the
/// mean of a Geman-McClure loss of the sine of the angle of Fig. 3.4, by Levenberg-Marquardt in the
/// axis' four degrees of freedom with analytic derivatives. The loss replaces the truncated angle
/// of Eq. 3.4, which has no derivative at the truncation. The axis' point is the foot of the
/// points' centroid. `cloud` has unit normals. Throws InputError on invalid options.
AxisFit fit_axis(const PointCloud& cloud, const RotationAxis& initial,
                 const AxisFitOptions& options = {});

/// Initial axes for fit_axis(): the axis of the helical motion under which the surface is most
/// nearly invariant, in closed form (Pottmann and Randrup 1998), then the principal axes (section
/// 3.5.2) and `more_directions` (unit), each placed where the lines of the normals come nearest to
/// it. Empty for fewer than eight points. `cloud` has unit normals. Throws InputError on invalid
/// options.
std::vector<RotationAxis> initial_axes(const PointCloud& cloud,
                                       const std::vector<Eigen::Vector3d>& more_directions,
                                       const AxisFitOptions& options = {});

}  // namespace symscene
