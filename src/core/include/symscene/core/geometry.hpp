#pragma once

#include <Eigen/Core>

namespace symscene {

/// The plane {x : normal · x + offset = 0} with a unit normal; for a table the normal points up.
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0.0;  ///< [m]

  double signed_distance(const Eigen::Vector3d& point) const { return normal.dot(point) + offset; }
};

/// A reflectional symmetry S^refl = {p, n} (section 3.3). The normal is a unit vector; (p, n) and
/// (p, −n) are one plane.
struct ReflectionPlane {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();

  double signed_distance(const Eigen::Vector3d& p) const { return normal.dot(p - point); }
  Eigen::Vector3d reflect_point(const Eigen::Vector3d& p) const {
    return p - 2.0 * signed_distance(p) * normal;
  }
  Eigen::Vector3d reflect_direction(const Eigen::Vector3d& d) const {
    return d - 2.0 * normal.dot(d) * normal;
  }
  Eigen::Vector3d project(const Eigen::Vector3d& p) const {
    return p - signed_distance(p) * normal;
  }
};

/// A rotational symmetry S^rot = {p, d} (section 3.3): every rotation about the line p + t d. d is
/// a unit vector.
struct RotationAxis {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();

  /// The rotation matrix about the direction of the axis by `angle`. [rad]
  Eigen::Matrix3d rotation(double angle) const;
  Eigen::Vector3d rotate_point(const Eigen::Vector3d& p, double angle) const;
  Eigen::Vector3d project(const Eigen::Vector3d& p) const {
    return point + direction.dot(p - point) * direction;
  }
  double distance(const Eigen::Vector3d& p) const { return (p - project(p)).norm(); }
};

/// The angle between two vectors in [0, π]; zero if either has no length. [rad]
double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// The angle between two lines with these directions, in [0, π/2]. [rad]
double line_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// The rotation by the smallest angle that turns the direction of `from` into that of `to`.
Eigen::Matrix3d shortest_rotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Two unit vectors that complete a unit vector to a right-handed orthonormal basis, as columns.
Eigen::Matrix<double, 3, 2> orthonormal_complement(const Eigen::Vector3d& direction);

/// The difference of two symmetries (Eqs. 3.11, 3.12): the angle between the lines or planes, and
/// the distance between the projections of a reference point at the object.
struct SymmetryDifference {
  double angle = 0.0;     ///< [rad]
  double distance = 0.0;  ///< [m]
};
SymmetryDifference difference(const RotationAxis& a, const RotationAxis& b,
                              const Eigen::Vector3d& reference);
SymmetryDifference difference(const ReflectionPlane& a, const ReflectionPlane& b,
                              const Eigen::Vector3d& reference);

/// The difference between a plane and the nearest plane that contains an axis: the angle between
/// plane and axis, and the distance between plane and axis near the reference point. It is zero if
/// the plane contains the axis, as mirror planes of a rotationally symmetric object do.
SymmetryDifference difference(const ReflectionPlane& plane, const RotationAxis& axis,
                              const Eigen::Vector3d& reference);

/// Whether two axes or two planes are one: they differ by less than `angle` and, near `reference`,
/// `distance`.
struct SameSymmetry {
  Eigen::Vector3d reference;
  double angle;     ///< [rad]
  double distance;  ///< [m]

  template <class Symmetry>
  bool operator()(const Symmetry& a, const Symmetry& b) const {
    const SymmetryDifference apart = difference(a, b, reference);
    return apart.angle < angle && apart.distance < distance;
  }
};

/// Maps [min, max] linearly to [0, 1] and clamps outside (Eqs. 3.5, 3.9, 4.2, 4.3, 4.6, 4.7).
template <class Scalar>
constexpr Scalar ramp(Scalar value, Scalar min, Scalar max) {
  return value <= min ? Scalar(0) : value >= max ? Scalar(1) : (value - min) / (max - min);
}

}  // namespace symscene
