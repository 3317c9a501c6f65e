#pragma once

#include <Eigen/Geometry>

namespace symscene {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// The motion with rotation vector ω and translation t, for a twist (ω, t).
inline Eigen::Isometry3d motion(const Vector6d& twist) {
  const Eigen::Vector3d omega = twist.head<3>();
  const double angle = omega.norm();
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  if (angle > 0.0) T.linear() = Eigen::AngleAxisd(angle, omega / angle).toRotationMatrix();
  T.translation() = twist.tail<3>();
  return T;
}

/// The twist (ω, t) of a motion: the inverse of motion().
inline Vector6d twist_of(const Eigen::Isometry3d& T) {
  const Eigen::AngleAxisd turn(T.linear());
  Vector6d twist;
  twist << turn.angle() * turn.axis(), T.translation();
  return twist;
}

/// The pose with its rotation made orthonormal again, so that rounding errors do not accumulate.
inline Eigen::Isometry3d orthonormal(Eigen::Isometry3d T) {
  T.linear() = Eigen::Quaterniond(T.linear()).normalized().toRotationMatrix();
  return T;
}

/// Jacobian of the moved point with respect to the twist (ω, t): ω × x + t.
inline Eigen::Matrix<double, 3, 6> point_jacobian(const Eigen::Vector3d& x) {
  Eigen::Matrix<double, 3, 6> J;
  J << 0, x.z(), -x.y(), 1, 0, 0,  //
      -x.z(), 0, x.x(), 0, 1, 0,   //
      x.y(), -x.x(), 0, 0, 0, 1;
  return J;
}

}  // namespace symscene
