#include "reprojection.hpp"

#include <limits>

#include "core/twist.hpp"

namespace symscene {
namespace {

constexpr int iterations = 10;
constexpr double nearest_depth = 0.05;  ///< nearer points are treated as outside the image [m]

Eigen::Vector2d error(const CameraIntrinsics& camera, const Eigen::Vector3d& point,
                      const Eigen::Vector2d& pixel) {
  if (!(point.z() > nearest_depth)) {
    return Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  }
  return camera.project(point) - pixel;
}

Eigen::Matrix<double, 2, 3> projection_jacobian(const CameraIntrinsics& camera,
                                                const Eigen::Vector3d& p) {
  Eigen::Matrix<double, 2, 3> J;
  J << camera.fx / p.z(), 0.0, -camera.fx * p.x() / (p.z() * p.z()),  //
      0.0, camera.fy / p.z(), -camera.fy * p.y() / (p.z() * p.z());
  return J;
}

struct System {
  Matrix6d H = Matrix6d::Zero();
  Vector6d g = Vector6d::Zero();

  void add(const Eigen::Matrix<double, 2, 6>& J, const Eigen::Vector2d& e, double scale) {
    const double weight = 1.0 / (1.0 + e.squaredNorm() / (scale * scale));
    H += weight * J.transpose() * J;
    g += weight * J.transpose() * e;
  }
};

System linearize(const SharedPoints& shared, const CameraIntrinsics& camera,
                 const Eigen::Isometry3d& T_first_second, double scale) {
  System system;
  const Eigen::Isometry3d T_second_first = T_first_second.inverse();
  for (Eigen::Index i = 0; i < shared.points_first.cols(); ++i) {
    const Eigen::Vector3d p_first = shared.points_first.col(i);
    const Eigen::Vector3d moved = T_first_second * shared.points_second.col(i);
    const Eigen::Vector2d there = error(camera, moved, shared.pixels_first.col(i));
    if (there.allFinite()) {
      system.add(projection_jacobian(camera, moved) * point_jacobian(moved), there, scale);
    }
    const Eigen::Vector3d back = T_second_first * p_first;
    const Eigen::Vector2d here = error(camera, back, shared.pixels_second.col(i));
    if (here.allFinite()) {
      system.add(
          projection_jacobian(camera, back) * -T_second_first.linear() * point_jacobian(p_first),
          here, scale);
    }
  }
  return system;
}

}  // namespace

Eigen::Vector2d error_in_first(const SharedPoints& shared, Eigen::Index i,
                               const CameraIntrinsics& camera,
                               const Eigen::Isometry3d& T_first_second) {
  return error(camera, T_first_second * shared.points_second.col(i), shared.pixels_first.col(i));
}

Eigen::Vector2d error_in_second(const SharedPoints& shared, Eigen::Index i,
                                const CameraIntrinsics& camera,
                                const Eigen::Isometry3d& T_first_second) {
  return error(camera, T_first_second.inverse() * shared.points_first.col(i),
               shared.pixels_second.col(i));
}

Eigen::Isometry3d refine_by_reprojection(const SharedPoints& shared, const CameraIntrinsics& camera,
                                         Eigen::Isometry3d T_first_second, double scale) {
  for (int k = 0; k < iterations; ++k) {
    System system = linearize(shared, camera, T_first_second, scale);
    system.H.diagonal() *= 1.0 + 1e-9;
    const Vector6d step = system.H.ldlt().solve(-system.g);
    if (!step.allFinite()) break;
    T_first_second = orthonormal(motion(step) * T_first_second);
    if (step.norm() < 1e-9) break;
  }
  return T_first_second;
}

}  // namespace symscene
