#include "true_symmetries.hpp"

#include <algorithm>
#include <cmath>

#include "symscene/symmetry/symmetry_group.hpp"

namespace symscene {
namespace {

constexpr double strict_residual = 0.008;                   // of the diagonal
const double least_cosine_across = std::cos(radians(5.0));  // of a normal with an axis it is across

bool is_across_axis(const ReflectionPlane& plane, const std::vector<TrueAxis>& axes) {
  return std::any_of(axes.begin(), axes.end(), [&](const TrueAxis& own) {
    return std::abs(own.axis.direction.dot(plane.normal)) > least_cosine_across;
  });
}

}  // namespace

TrueObject true_symmetries(const std::string& name, const TriangleMesh& surface) {
  const SymmetryGroup group = find_symmetry_group(even_surface(surface));
  const auto is_strict = [&](double residual) {
    return residual <= strict_residual * group.diagonal;
  };
  TrueObject truth;
  truth.name = name;
  truth.sphere = group.sphere;
  truth.centroid = group.center;
  for (const GroupAxis& own : group.axes) {
    if (own.order == GroupAxis::continuous)
      truth.rotational.push_back({own.axis, is_strict(own.residual)});
  }
  for (const GroupPlane& own : group.planes) {
    const bool strict = is_strict(own.residual) && !is_across_axis(own.plane, truth.rotational);
    truth.reflectional.push_back({own.plane, strict});
  }
  return truth;
}

TrueObject placed(TrueObject object, double scale, const Eigen::Isometry3d& T_world_object) {
  const auto point = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return T_world_object * (scale * p);
  };
  object.centroid = point(object.centroid);
  for (TrueAxis& own : object.rotational)
    own.axis = {point(own.axis.point), T_world_object.linear() * own.axis.direction};
  for (TruePlane& own : object.reflectional)
    own.plane = {point(own.plane.point), T_world_object.linear() * own.plane.normal};
  return object;
}

}  // namespace symscene
