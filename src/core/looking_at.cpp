#include "core/looking_at.hpp"

namespace symscene {

Eigen::Isometry3d looking_along(const Eigen::Vector3d& eye, const Eigen::Vector3d& forward,
                                const Eigen::Vector3d& up) {
  const Eigen::Vector3d across = forward.cross(up);
  const Eigen::Vector3d right = across.norm() > 1e-6 * up.norm()
                                    ? Eigen::Vector3d(across.normalized())
                                    : forward.unitOrthogonal();
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  T_world_camera.linear() << right, forward.cross(right), forward;
  T_world_camera.translation() = eye;
  return T_world_camera;
}

Eigen::Isometry3d looking_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& target,
                             const Eigen::Vector3d& up) {
  return looking_along(eye, (target - eye).normalized(), up);
}

}  // namespace symscene
