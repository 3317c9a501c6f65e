#include "view_matching.hpp"

#include <algorithm>

namespace symscene {
namespace {

/// From a twist in the world to the same motion in a camera's frame.
Matrix6d twist_in_camera(const Eigen::Isometry3d& T_world_camera) {
  const Eigen::Matrix3d R = T_world_camera.linear().transpose();
  Matrix6d adjoint = Matrix6d::Zero();
  adjoint.topLeftCorner<3, 3>() = R;
  adjoint.bottomRightCorner<3, 3>() = R;
  adjoint.bottomLeftCorner<3, 3>() = R * point_jacobian(T_world_camera.translation()).leftCols<3>();
  return adjoint;
}

}  // namespace

PairSystem match_surfaces(const PlacedSurface& moved, const PlacedSurface& fixed,
                          const MatchOptions& options) {
  const PointToPlaneMatcher matcher(moved.image, fixed.image, options);
  const NormalEquations equations =
      matcher.match(fixed.T_world_camera.inverse() * moved.T_world_camera);
  const Matrix6d to_camera = twist_in_camera(fixed.T_world_camera);
  // Weights in 1/m², as those of paired points.
  const double unit = matcher.unit_weight();
  PairSystem system;
  system.A = unit * to_camera.transpose() * equations.H * to_camera;
  system.b = -unit * to_camera.transpose() * equations.b;
  system.fit = equations.fit;
  return system;
}

PairSystem match_points(const PointPairs& pairs, const Eigen::Isometry3d& T_world_first,
                        const Eigen::Isometry3d& T_world_second,
                        const ViewAlignmentOptions& options) {
  PairSystem system;
  for (Eigen::Index i = 0; i < pairs.points_first.cols(); ++i) {
    const double z = std::max(pairs.points_first(2, i), pairs.points_second(2, i));
    const double deviation = options.point_deviation * std::max(1.0, z * z);
    const Eigen::Vector3d x = T_world_first * pairs.points_first.col(i);
    const Eigen::Vector3d e = x - T_world_second * pairs.points_second.col(i);
    const double bound = options.robust_sigmas * deviation;
    const double weight = 1.0 / ((1.0 + e.squaredNorm() / (bound * bound)) * deviation * deviation);
    const Eigen::Matrix<double, 3, 6> J = point_jacobian(x);
    system.A += weight * J.transpose() * J;
    system.b += weight * J.transpose() * e;
  }
  return system;
}

}  // namespace symscene
