#include "symscene/classes/class_symmetries.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace symscene {
namespace {

template <class Symmetry>
void sort_by_residual(std::vector<Symmetry>& symmetries) {
  std::stable_sort(symmetries.begin(), symmetries.end(),
                   [](const Symmetry& a, const Symmetry& b) { return a.residual < b.residual; });
}

bool has_axis(const ObjectClass& found) {
  return found.kind == SymmetryClass::n_fold || found.kind == SymmetryClass::revolution ||
         found.kind == SymmetryClass::cylinder;
}

/// The columns of `axes` that are normals of planes of the class.
std::vector<int> normals_of(SymmetryClass kind) {
  switch (kind) {
    case SymmetryClass::mirror:
      return {0};
    case SymmetryClass::prism:
      return {0, 1};
    case SymmetryClass::box:
      return {0, 1, 2};
    case SymmetryClass::n_fold:
    case SymmetryClass::cylinder:
      return {2};
    default:
      return {};
  }
}

/// The length of a surface across the plane with that normal; none of classes without dimensions.
const Dimension* length_along(const ObjectClass& found, int axis) {
  if (found.dimensions.empty()) return nullptr;
  return found.kind == SymmetryClass::box ? &found.dimensions[static_cast<std::size_t>(axis)]
                                          : &found.dimensions.back();
}

/// Whether an end across that axis is hidden, so that the centre is that of what is seen there.
bool is_open_along(const ObjectClass& found, int axis) {
  const Dimension* length = length_along(found, axis);
  return length != nullptr && !length->sigma;
}

/// The plane of the class across that axis near a listed one. Where an end is hidden the listed one
/// tells its place, if it goes through what is seen.
std::optional<ReflectionPlane> plane_across(const ObjectClass& found, int axis,
                                            const ReflectionPlane& listed) {
  const Eigen::Vector3d normal = found.axes.col(axis);
  if (!is_open_along(found, axis)) return ReflectionPlane{found.center, normal};
  // Where the axis through the centre meets the listed plane.
  const double offset = -listed.signed_distance(found.center) / listed.normal.dot(normal);
  if (std::abs(offset) > 0.5 * length_along(found, axis)->value) return std::nullopt;
  return ReflectionPlane{found.center + offset * normal, normal};
}

/// The plane through the axis of a class near a normal. Those of a regular prism go through the
/// middle of its sides or through its edges.
Eigen::Vector3d normal_across_axis(const ObjectClass& found, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d local = found.axes.transpose() * normal;
  double angle = std::atan2(local.y(), local.x());
  if (found.kind == SymmetryClass::n_fold) {
    constexpr double quarter = std::numbers::pi / 2;
    const double step = std::numbers::pi / found.order;
    angle = quarter + step * std::round((angle - quarter) / step);
  }
  return found.axes * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
}

/// The diagonal plane near a listed one of a box whose sides across it are equal, as far as their
/// deviations tell.
std::optional<ReflectionPlane> diagonal_near(const ObjectClass& box, const ReflectionPlane& listed,
                                             double same_angle) {
  constexpr double most_sigmas = 2.0;
  if (box.kind != SymmetryClass::box || box.dimensions.empty()) return std::nullopt;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const Dimension& a = box.dimensions[static_cast<std::size_t>(i)];
    const Dimension& b = box.dimensions[static_cast<std::size_t>(j)];
    if (!a.sigma || !b.sigma) continue;
    if (std::abs(a.value - b.value) > most_sigmas * std::hypot(*a.sigma, *b.sigma)) continue;
    for (const double sign : {-1.0, 1.0}) {
      const Eigen::Vector3d normal = (box.axes.col(i) + sign * box.axes.col(j)).normalized();
      if (line_angle(normal, listed.normal) < same_angle)
        return ReflectionPlane{box.center, normal};
    }
  }
  return std::nullopt;
}

/// The plane of the class near a listed one; none where the class has no such plane.
std::optional<ReflectionPlane> plane_near(const ObjectClass& found, const ReflectionPlane& listed,
                                          double same_angle) {
  if (found.kind == SymmetryClass::sphere) return ReflectionPlane{found.center, listed.normal};
  for (const int axis : normals_of(found.kind)) {
    if (line_angle(found.axes.col(axis), listed.normal) < same_angle)
      return plane_across(found, axis, listed);
  }
  if (!has_axis(found)) return diagonal_near(found, listed, same_angle);
  const Eigen::Vector3d normal = normal_across_axis(found, listed.normal);
  if (line_angle(normal, listed.normal) >= same_angle) return std::nullopt;
  return ReflectionPlane{found.center, normal};
}

bool lists(const std::vector<ObjectPlane>& planes, const Eigen::Vector3d& normal,
           double same_angle) {
  return std::any_of(planes.begin(), planes.end(), [&](const ObjectPlane& listed) {
    return line_angle(listed.plane.normal, normal) < same_angle;
  });
}

/// Whether a plane of the class has nearly the same normal.
bool is_parallel_to(const ObjectClass& found, const ReflectionPlane& plane, double same_angle) {
  const std::vector<int> normals = normals_of(found.kind);
  return std::any_of(normals.begin(), normals.end(), [&](int axis) {
    return line_angle(found.axes.col(axis), plane.normal) < same_angle;
  });
}

/// The listed planes. Those that are symmetries of the class are moved onto it, each once; a body
/// has no second plane parallel to one of these.
std::vector<ObjectPlane> planes_of_class(const ObjectClass& found,
                                         const std::vector<ObjectPlane>& listed,
                                         double same_angle) {
  std::vector<ObjectPlane> kept;
  for (const auto& [plane, residual] : listed) {
    const std::optional<ReflectionPlane> near = plane_near(found, plane, same_angle);
    if (!near) {
      if (!is_parallel_to(found, plane, same_angle)) kept.push_back({plane, residual});
    } else if (!lists(kept, near->normal, same_angle)) {
      kept.push_back({*near, residual});
    }
  }
  return kept;
}

/// The listed axes. Those that are symmetries of the class are moved onto it.
std::vector<ObjectAxis> axes_of_class(const ObjectClass& found,
                                      const std::vector<ObjectAxis>& listed, double same_angle) {
  std::vector<ObjectAxis> kept;
  for (const auto& [axis, residual] : listed) {
    if (found.kind == SymmetryClass::sphere) {
      kept.push_back({{found.center, axis.direction}, residual});
    } else if (has_axis(found) && line_angle(found.axes.col(2), axis.direction) < same_angle) {
      kept.push_back({{found.center, found.axes.col(2)}, residual});
    } else {
      kept.push_back({axis, residual});
    }
  }
  return kept;
}

/// Adds the planes of a box between ends that are known.
void complete_box(const ObjectClass& box, double same_angle, std::vector<ObjectPlane>& planes) {
  for (std::size_t k = 0; k < box.dimensions.size(); ++k) {
    const Eigen::Vector3d normal = box.axes.col(static_cast<Eigen::Index>(k));
    if (box.dimensions[k].sigma && !lists(planes, normal, same_angle))
      planes.push_back({{box.center, normal}, 1.0 - box.explained});
  }
}

/// Adds the axis of a cylinder, from which planes through it follow.
void complete_cylinder(const ObjectClass& cylinder, double same_angle, SymmetryLists& listed) {
  if (!listed.rotational.empty()) return;
  const RotationAxis axis{cylinder.center, cylinder.axes.col(2)};
  listed.rotational.push_back({axis, 1.0 - cylinder.explained});
  std::erase_if(listed.reflectional, [&](const ObjectPlane& plane) {
    return difference(plane.plane, axis, cylinder.center).angle < same_angle;
  });
}

}  // namespace

SymmetryLists with_symmetries_of_class(SymmetryLists listed, const ObjectClass& symmetry_class,
                                       double same_angle) {
  if (symmetry_class.kind == SymmetryClass::none) return listed;
  sort_by_residual(listed.rotational);
  sort_by_residual(listed.reflectional);
  listed.rotational = axes_of_class(symmetry_class, listed.rotational, same_angle);
  listed.reflectional = planes_of_class(symmetry_class, listed.reflectional, same_angle);
  if (symmetry_class.dimensions.empty()) return listed;
  if (symmetry_class.kind == SymmetryClass::box)
    complete_box(symmetry_class, same_angle, listed.reflectional);
  if (symmetry_class.kind == SymmetryClass::cylinder)
    complete_cylinder(symmetry_class, same_angle, listed);
  sort_by_residual(listed.rotational);
  sort_by_residual(listed.reflectional);
  return listed;
}

ObjectClass centred_on_planes(ObjectClass symmetry_class, const std::vector<ObjectPlane>& listed) {
  constexpr double equal = 1e-4;  // of a listed normal and the class's [rad]
  for (const int axis : normals_of(symmetry_class.kind)) {
    if (!is_open_along(symmetry_class, axis)) continue;
    for (const ObjectPlane& across : listed) {
      if (line_angle(across.plane.normal, symmetry_class.axes.col(axis)) < equal)
        symmetry_class.center = across.plane.project(symmetry_class.center);
    }
  }
  return symmetry_class;
}

}  // namespace symscene
