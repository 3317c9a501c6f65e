#include "classes/class_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace symscene {

ClassSurface::ClassSurface(const ObjectClass& found)
    : kind_(found.kind), order_(found.order), center_(found.center), axes_(found.axes) {
  const bool is_box = kind_ == SymmetryClass::box;
  if (!is_box) size_ = found.dimensions.front().value;
  for (std::size_t k = is_box ? 0 : 1; k < found.dimensions.size(); ++k) {
    const std::size_t axis = is_box ? k : 2;
    half_extents_[static_cast<Eigen::Index>(axis)] = 0.5 * found.dimensions[k].value;
    is_determined_[axis] = found.dimensions[k].sigma.has_value();
  }
}

void ClassSurface::add_ends(int axis, const Eigen::Vector3d& local, Faces& faces) const {
  for (const double sign : {-1.0, 1.0})
    faces.add({sign * Eigen::Vector3d::Unit(axis), sign * local[axis] - half_extents_[axis],
               is_determined_[static_cast<std::size_t>(axis)]});
}

void ClassSurface::add_sides(const Eigen::Vector3d& local, Faces& faces) const {
  if (kind_ == SymmetryClass::n_fold) {
    for (int f = 0; f < order_; ++f) {
      const double angle = 2.0 * std::numbers::pi * f / order_;
      const Eigen::Vector3d normal(std::cos(angle), std::sin(angle), 0.0);
      faces.add({normal, normal.dot(local) - size_});
    }
    return;
  }
  Eigen::Vector3d away = local;
  if (kind_ == SymmetryClass::cylinder) away.z() = 0.0;
  const double distance = away.norm();
  if (distance > 0.0) faces.add({away / distance, distance - size_});
}

ClassSurface::Faces ClassSurface::faces_at(const Eigen::Vector3d& local) const {
  Faces faces;
  if (kind_ == SymmetryClass::box) {
    for (int axis = 0; axis < 3; ++axis) add_ends(axis, local, faces);
    return faces;
  }
  add_sides(local, faces);
  if (kind_ != SymmetryClass::sphere) add_ends(2, local, faces);
  return faces;
}

float ClassSurface::residual(const Eigen::Vector3f& position, const Eigen::Vector3f& normal,
                             const SurfaceBounds& bounds) const {
  const Faces faces = faces_at(axes_.transpose() * (position.cast<double>() - center_));
  const Eigen::Vector3d local_normal = axes_.transpose() * normal.cast<double>();
  float agreement = 0.0F;
  for (std::size_t f = 0; f < faces.count; ++f) {
    double distance = std::abs(faces.all[f].distance);
    for (std::size_t g = 0; g < faces.count; ++g) {
      if (g != f && faces.all[g].is_end) distance = std::max(distance, faces.all[g].distance);
    }
    const double cosine = std::clamp(local_normal.dot(faces.all[f].normal), -1.0, 1.0);
    const float near = 1.0F - bounds.distance(static_cast<float>(distance));
    const float aligned = 1.0F - bounds.angle(static_cast<float>(std::acos(cosine)));
    agreement = std::max(agreement, near * aligned);
  }
  return 1.0F - agreement;
}

}  // namespace symscene
