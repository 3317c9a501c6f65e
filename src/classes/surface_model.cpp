#include "surface_model.hpp"

namespace symscene {

std::array<bool, 13> SurfaceModel::active() const {
  std::array<bool, 13> is_active{};
  const bool has_sides = kind != Kind::box;
  is_active[0] = is_active[1] = kind != Kind::sphere;
  is_active[2] = kind == Kind::box || kind == Kind::prism;
  is_active[3] = is_active[4] = is_active[6] = has_sides;
  is_active[5] = kind == Kind::sphere;
  for (std::size_t f = 0; f < present.size(); ++f) is_active[7 + f] = present[f];
  return is_active;
}

void SurfaceModel::move(const SurfaceStep& step) {
  const Eigen::Vector3d turn = step.head<3>();
  origin += axes * step.segment<3>(3);
  const double angle = turn.norm();
  if (angle > 0.0) {
    const Eigen::Matrix3d turned = axes * Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
    axes = Eigen::Quaterniond(turned).normalized().toRotationMatrix();
  }
  size += step[6];
  for (std::size_t f = 0; f < offsets.size(); ++f)
    offsets[f] += step[static_cast<Eigen::Index>(7 + f)];
}

SurfaceStep distance_gradient(const SurfaceModel& model, int f, const Eigen::Vector3d& local) {
  const Eigen::Vector3d normal = model.normal(f, local);
  SurfaceStep gradient = SurfaceStep::Zero();
  gradient.head<3>() = normal.cross(local);
  gradient.segment<3>(3) = -normal;
  gradient[f < SurfaceModel::planar_faces ? 7 + f : 6] = -1.0;
  return gradient;
}

}  // namespace symscene
