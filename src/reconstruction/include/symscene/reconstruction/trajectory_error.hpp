#pragma once

#include <span>

#include <Eigen/Geometry>

namespace symscene {

/// How far a camera's estimated path is from its true one (Sturm et al. 2012, "A benchmark for the
/// evaluation of RGB-D SLAM systems").
struct TrajectoryError {
  std::size_t poses = 0;
  std::size_t interval = 0;     ///< poses over which the relative error is
  double absolute = 0.0;        ///< root mean square distance after rigid alignment [m]
  double absolute_max = 0.0;    ///< the largest of these [m]
  double relative = 0.0;        ///< root mean square error of the motion over `interval` [m]
  double relative_angle = 0.0;  ///< the same of its rotation [rad]
  double drift = 0.0;           ///< error of the motion from the first to the last pose [m]
  double length = 0.0;          ///< of the true path [m]
};

/// Compares pose by pose. The relative error is over `interval` poses, or all where there are
/// fewer. Throws InputError if there are not as many of one as of the other.
TrajectoryError trajectory_error(std::span<const Eigen::Isometry3d> estimated,
                                 std::span<const Eigen::Isometry3d> truth,
                                 std::size_t interval = 30);

}  // namespace symscene
