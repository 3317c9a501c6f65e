#pragma once

#include <optional>

#include <Eigen/Core>

#include "fit_samples.hpp"
#include "surface_model.hpp"

namespace symscene {

/// Bounds of a fit to the points of an object.
struct FitBounds {
  double tolerance = 0.005;   ///< distance up to which a point is explained [m]
  double face_cosine = 0.94;  ///< least cosine of the normals of a point and of its face
  double min_face_share = 0.04;
  double min_scale = 1e-4;  ///< of residuals [m]
  double correlated = 1.0;  ///< samples whose errors are as one
};

/// A surface that is fitted to points.
struct SurfaceFit {
  SurfaceModel model;
  double scale = 0.0;      ///< robust standard deviation of the residuals [m]
  double explained = 0.0;  ///< share of the samples
  double residual = 0.0;   ///< root mean square distance of the explained samples [m]
  double criterion = 0.0;  ///< Bayesian information criterion, up to a common constant
  /// Covariance of the parameters for independent samples with `scale`; zero for inactive ones.
  Eigen::Matrix<double, 13, 13> covariance = Eigen::Matrix<double, 13, 13>::Zero();
};

/// The face of which the normal is nearest to that of a point; none beyond the bound. Local frame.
std::optional<int> nearest_face(const SurfaceModel& model, const Eigen::Vector3d& local,
                                const Eigen::Vector3d& normal, double face_cosine);

/// Whether a point lies on the surface of the observed faces and faces outwards. World frame.
bool is_explained(const SurfaceModel& model, const Eigen::Vector3d& point,
                  const Eigen::Vector3d& normal, double tolerance);

/// Signed distance from the observed faces of the surface, negative inside. [m]
double signed_distance(const SurfaceModel& model, const Eigen::Vector3d& local);

/// Places the planar faces of a model at the offset of most points; faces that have too few, or
/// points beyond them, are not present.
void place_planar_faces(SurfaceModel& model, const FitSamples& samples, const FitBounds& bounds);

/// Minimises the Geman-McClure loss of the distances of points from their faces by
/// Levenberg-Marquardt. None if the points do not determine the parameters.
std::optional<SurfaceFit> fit_surface(const SurfaceModel& initial, const FitSamples& samples,
                                      const FitBounds& bounds);

}  // namespace symscene
