#pragma once

#include <cmath>

#include <Eigen/Geometry>

#include "reconstruction/surface_image.hpp"

namespace symscene {

/// The standard deviation of the distance between two measurements of one surface, in the noise
/// model of Khoshelham and Elberink (2012), Eq. 10.
struct DepthNoise {
  float floor = 0.0F;  ///< deviation that does not depend on depth [m]
  float moved = 0.0F;  ///< deviation over squared depth of the moved image [1/m]
  float fixed = 0.0F;  ///< the same of the fixed image; 0 if it shows a model [1/m]

  /// From the depths of both pixels, each in its own camera. [m]
  float deviation(float moved_depth, float fixed_depth) const {
    const float a = moved * moved_depth * moved_depth;
    const float b = fixed * fixed_depth * fixed_depth;
    return floor + std::sqrt(a * a + b * b);
  }
};

/// Residuals up to this many deviations are inliers.
constexpr float inlier_sigmas = 3.0F;

/// How well one image fits another under a pose, by which tracking and stitching accept it.
struct PoseFit {
  double points = 0.0;   ///< surface pixels of the moved image
  double shown = 0.0;    ///< of these, pixels that can be compared with the fixed image
  double matches = 0.0;  ///< of these, pixels that match one of the fixed image
  double inliers = 0.0;  ///< matches within three deviations
  double squares = 0.0;  ///< sum of the squared residuals of the inliers [m²]

  PoseFit& operator+=(const PoseFit& other);

  double overlap() const { return share(matches, points); }
  double inlier_share() const { return share(inliers, matches); }
  double agreement() const { return share(inliers, shown); }
  /// Root mean square residual of the inliers. [m]
  double residual() const { return std::sqrt(share(squares, inliers)); }

 private:
  static double share(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }
};

/// Compares depths only, without normals: a point of `moved` is an inlier if its depth in the fixed
/// camera is within three deviations of the depth measured there. It is shown if it is an inlier or
/// lies in front of that depth, in space that `fixed` has seen to be empty; points behind it are
/// occluded and do not affect the result.
PoseFit depth_fit(const SurfaceImage& moved, const SurfaceImage& fixed,
                  const Eigen::Isometry3d& T_fixed_moved, const DepthNoise& noise);

}  // namespace symscene
