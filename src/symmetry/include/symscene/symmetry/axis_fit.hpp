#pragma once

#include <vector>

#include "symscene/core/geometry.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// How an iterative fit ended.
enum class FitStatus { converged, iteration_limit, too_few_points, degenerate };

/// Whether a fit that ended so is better than where it began.
inline bool is_usable(FitStatus status) {
  return status == FitStatus::converged || status == FitStatus::iteration_limit;
}

struct AxisFitOptions {
  double residual_scale = radians(15.0);  ///< angles well above this count as outliers [rad]
  double position_noise = 0.003;  ///< points nearer to the axis than some of these say little [m]
  int max_iterations = 30;
  int max_points = 800;  ///< larger inputs are thinned evenly

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("residual_scale", self.residual_scale, "rad", "angles well above this count as outliers");
    visit("position_noise", self.position_noise, "m",
          "points not much farther from the axis say little");
    visit("max_iterations", self.max_iterations, "", "most steps of a fit");
    visit("max_points", self.max_points, "points", "larger inputs are thinned evenly");
  }
  /// Throws InputError on a length or count that is not positive.
  void validate() const;
};

struct AxisFit {
  RotationAxis axis;
  double cost = 0.0;  ///< mean robust cost in [0, 1]; comparable between fits of the same points
  FitStatus status = FitStatus::too_few_points;
};

/// The axis near `initial` in whose planes the points' normals lie (section 3.5.2): minimises the
/// mean of a Geman-McClure loss of the sine of the angle of Fig. 3.4, by Levenberg-Marquardt in the
/// axis' four degrees of freedom with analytic derivatives. The loss is smooth where Eq. 3.4 has a
/// corner and forgets outliers as it does. The axis' point is the foot of the points' centroid.
/// `cloud` has normals.
AxisFit fit_axis(const PointCloud& cloud, const RotationAxis& initial,
                 const AxisFitOptions& options = {});

/// Where to begin: the axis in closed form of the motion that best slides the surface along itself
/// (Pottmann and Randrup 1998), and the principal axes (section 3.5.2) and `more_directions`, each
/// at the place where the normals meet it best.
std::vector<RotationAxis> initial_axes(const PointCloud& cloud,
                                       const std::vector<Eigen::Vector3d>& more_directions,
                                       const AxisFitOptions& options = {});

}  // namespace symscene
