#include "symscene/classes/class_symmetries.hpp"

#include <algorithm>

namespace symscene {
namespace {

constexpr double most_uncertain = 0.1;  // deviation of a dimension whose plane is added, over it

template <class Symmetry>
void sort_by_residual(std::vector<Symmetry>& symmetries) {
  std::stable_sort(symmetries.begin(), symmetries.end(),
                   [](const Symmetry& a, const Symmetry& b) { return a.residual < b.residual; });
}

bool is_determined(const Dimension& dimension) {
  return dimension.sigma && *dimension.sigma < most_uncertain * dimension.value;
}

/// A plane of a class in the place of the listed one near it, or in addition.
void put_plane(std::vector<ObjectPlane>& planes, const ReflectionPlane& plane, double residual,
               double same_angle) {
  const auto near = std::find_if(planes.begin(), planes.end(), [&](const ObjectPlane& listed) {
    return line_angle(listed.plane.normal, plane.normal) < same_angle;
  });
  if (near == planes.end()) {
    planes.push_back({plane, residual});
  } else {
    near->plane = plane;
  }
}

void put_box(const ObjectClass& box, double same_angle, SymmetryLists& listed) {
  for (std::size_t k = 0; k < box.dimensions.size(); ++k) {
    if (!is_determined(box.dimensions[k])) continue;
    put_plane(listed.reflectional, {box.center, box.axes.col(static_cast<Eigen::Index>(k))},
              1.0 - box.explained, same_angle);
  }
}

void put_axis(const ObjectClass& cylinder, double same_angle, SymmetryLists& listed) {
  const RotationAxis axis{cylinder.center, cylinder.axes.col(2)};
  const auto near = std::find_if(
      listed.rotational.begin(), listed.rotational.end(), [&](const ObjectAxis& other) {
        return line_angle(other.axis.direction, axis.direction) < same_angle;
      });
  if (near != listed.rotational.end()) {
    near->axis = axis;
    return;
  }
  if (!listed.rotational.empty()) return;  // a bounded body with two axes is a sphere
  listed.rotational.push_back({axis, 1.0 - cylinder.explained});
  std::erase_if(listed.reflectional, [&](const ObjectPlane& listed_plane) {
    return difference(listed_plane.plane, axis, cylinder.center).angle < same_angle;
  });
}

}  // namespace

SymmetryLists with_symmetries_of_class(SymmetryLists listed, const ObjectClass& symmetry_class,
                                       double same_angle) {
  if (symmetry_class.dimensions.empty()) return listed;
  if (symmetry_class.kind == SymmetryClass::box) put_box(symmetry_class, same_angle, listed);
  if (symmetry_class.kind == SymmetryClass::cylinder) put_axis(symmetry_class, same_angle, listed);
  sort_by_residual(listed.rotational);
  sort_by_residual(listed.reflectional);
  return listed;
}

}  // namespace symscene
