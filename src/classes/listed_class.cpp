#include "listed_class.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "core/nearest_orthogonal.hpp"
#include "core/perpendicular_planes.hpp"
#include "symmetry_frame.hpp"

namespace symscene {
namespace {

/// The rotation nearest to normals that are nearly at right angles; a missing third one is added.
Eigen::Matrix3d nearest_frame(const std::vector<ReflectionPlane>& planes) {
  Eigen::Matrix3d normals;
  normals.col(0) = planes[0].normal;
  normals.col(1) = planes[1].normal;
  normals.col(2) =
      planes.size() > 2 ? planes[2].normal : normals.col(0).cross(normals.col(1)).normalized();
  if (normals.determinant() < 0.0) normals.col(2) = -normals.col(2);
  return nearest_orthogonal(normals);
}

/// The centre of the points, moved onto planes at right angles.
Eigen::Vector3d projected(Eigen::Vector3d center, const std::vector<ReflectionPlane>& planes) {
  for (const ReflectionPlane& plane : planes) center = plane.project(center);
  return center;
}

ObjectClass class_in_frame(SymmetryClass kind, const SymmetryFrame& initial,
                           const ClassifiedObject& object) {
  const CellList cells(object.points.positions, static_cast<float>(2.0 * object.spacing));
  const SymmetryFrame fit = fit_frame({object.points, cells}, initial, object.spacing);
  return {.kind = kind, .center = fit.center, .axes = fit.axes, .residual = fit.residual};
}

ObjectClass class_of_axis(const ClassifiedObject& object, double max_square_error) {
  const RotationAxis& axis = object.axes.front().axis;
  SymmetryFrame initial;
  initial.rotates = true;
  initial.axes = frame_about(axis.direction);
  initial.center = axis.project(centroid(object.points.positions));
  const auto across =
      std::find_if(object.planes.begin(), object.planes.end(), [&](const ObjectPlane& candidate) {
        return line_angle(candidate.plane.normal, axis.direction) < max_square_error;
      });
  if (across == object.planes.end())
    return class_in_frame(SymmetryClass::revolution, initial, object);
  initial.mirrors[2] = true;
  initial.center += axis.direction.dot(across->plane.point - initial.center) * axis.direction;
  return class_in_frame(SymmetryClass::cylinder, initial, object);
}

ObjectClass class_of_planes(const ClassifiedObject& object, double max_square_error) {
  const std::vector<ReflectionPlane> planes = perpendicular_planes(object.planes, max_square_error);
  const Eigen::Vector3d center = projected(centroid(object.points.positions), planes);
  if (planes.size() == 1) {
    Eigen::Matrix3d axes = frame_about(planes[0].normal);
    axes.col(0).swap(axes.col(2));
    axes.col(1) = -axes.col(1);
    return {.kind = SymmetryClass::mirror, .center = center, .axes = axes};
  }
  SymmetryFrame initial;
  initial.axes = nearest_frame(planes);
  initial.center = center;
  initial.mirrors = {true, true, planes.size() > 2};
  return class_in_frame(planes.size() > 2 ? SymmetryClass::box : SymmetryClass::prism, initial,
                        object);
}

}  // namespace

ObjectClass class_of_symmetries(const ClassifiedObject& object, const ClassOptions& options) {
  if (object.points.empty()) return {};
  if (!object.axes.empty()) return class_of_axis(object, options.square_tolerance);
  if (!object.planes.empty()) return class_of_planes(object, options.square_tolerance);
  return {.center = centroid(object.points.positions)};
}

}  // namespace symscene
