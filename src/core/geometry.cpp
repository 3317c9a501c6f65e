#include "symscene/core/geometry.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace symscene {

Eigen::Matrix3d RotationAxis::rotation(double angle) const {
  return Eigen::AngleAxisd(angle, direction).toRotationMatrix();
}

Eigen::Vector3d RotationAxis::rotate_point(const Eigen::Vector3d& p, double angle) const {
  return point + rotation(angle) * (p - point);
}

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double line_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

// Compiled here only: Eigen's function instantiates a singular value decomposition.
Eigen::Matrix3d shortest_rotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

Eigen::Matrix<double, 3, 2> orthonormal_complement(const Eigen::Vector3d& direction) {
  Eigen::Matrix<double, 3, 2> basis;
  basis.col(0) = direction.unitOrthogonal();
  basis.col(1) = direction.cross(basis.col(0));
  return basis;
}

namespace {

SymmetryDifference difference_at(double angle, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {angle, (a - b).norm()};
}

}  // namespace

SymmetryDifference difference(const RotationAxis& a, const RotationAxis& b,
                              const Eigen::Vector3d& reference) {
  return difference_at(line_angle(a.direction, b.direction), a.project(reference),
                       b.project(reference));
}

SymmetryDifference difference(const ReflectionPlane& a, const ReflectionPlane& b,
                              const Eigen::Vector3d& reference) {
  return difference_at(line_angle(a.normal, b.normal), a.project(reference), b.project(reference));
}

SymmetryDifference difference(const ReflectionPlane& plane, const RotationAxis& axis,
                              const Eigen::Vector3d& reference) {
  return {0.5 * std::numbers::pi - line_angle(plane.normal, axis.direction),
          std::abs(plane.signed_distance(axis.project(reference)))};
}

}  // namespace symscene
