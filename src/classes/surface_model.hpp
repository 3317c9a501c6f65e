#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace symscene {

/// The parameters that a fit changes: a turn and a shift in the surface's own frame, the radius or
/// apothem, and the offsets of its planar faces.
using SurfaceStep = Eigen::Matrix<double, 13, 1>;

/// A closed convex surface of few parameters, in its own frame: planar faces across the axes, and
/// for all but the box sides about the third one. One rotation holds all faces, so that they are
/// exactly perpendicular.
struct SurfaceModel {
  enum class Kind { box, prism, cylinder, sphere };
  static constexpr int planar_faces = 6;  ///< face 2k is at −axis k, face 2k + 1 at +axis k

  Kind kind = Kind::box;
  int sides = 0;                                       ///< of a prism
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns, in the world
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();    ///< in the world [m]
  double size = 0.0;                                   ///< radius or apothem [m]
  std::array<double, planar_faces> offsets{};          ///< distances from the origin [m]
  std::array<bool, planar_faces> present{};            ///< whether a planar face was observed

  /// Planar faces, then sides.
  int faces() const {
    return kind == Kind::box ? planar_faces : planar_faces + (kind == Kind::prism ? sides : 1);
  }
  /// The axes across which the surface may have planar faces are [first_axis(), 3).
  int first_axis() const { return kind == Kind::box ? 0 : kind == Kind::sphere ? 3 : 2; }
  bool has_face(int f) const { return f >= planar_faces || present[static_cast<std::size_t>(f)]; }

  Eigen::Vector3d to_local(const Eigen::Vector3d& point) const {
    return axes.transpose() * (point - origin);
  }

  static Eigen::Vector3d planar_normal(int f) {
    return (f % 2 == 0 ? -1.0 : 1.0) * Eigen::Vector3d::Unit(f / 2);
  }

  /// The outward normal of a face at a local point. On the axis or at the centre it is arbitrary.
  Eigen::Vector3d normal(int f, const Eigen::Vector3d& local) const {
    if (f < planar_faces) return planar_normal(f);
    if (kind == Kind::prism) {
      const double angle = 2.0 * std::numbers::pi * (f - planar_faces) / sides;
      return {std::cos(angle), std::sin(angle), 0.0};
    }
    Eigen::Vector3d away = local;
    if (kind == Kind::cylinder) away.z() = 0.0;
    const double length = away.norm();
    return length > 0.0 ? Eigen::Vector3d(away / length) : Eigen::Vector3d::UnitX();
  }

  double offset(int f) const {
    return f < planar_faces ? offsets[static_cast<std::size_t>(f)] : size;
  }

  /// Signed distance of a local point from a face, positive outside. [m]
  double distance(int f, const Eigen::Vector3d& local) const {
    return normal(f, local).dot(local) - offset(f);
  }

  /// The parameters that a fit may change.
  std::array<bool, 13> active() const;

  void move(const SurfaceStep& step);
};

/// The derivative of distance(f, local) with respect to a step.
SurfaceStep distance_gradient(const SurfaceModel& model, int f, const Eigen::Vector3d& local);

}  // namespace symscene
