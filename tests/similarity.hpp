#pragma once

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "core/random_clouds.hpp"
#include "symscene/core/geometry.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/core/scene.hpp"

/// Motions and scalings of the input of a stage, for tests that its result moves or scales with it.
namespace symscene::testing {

/// The factors of scaling. Powers of two change no mantissa: all results scale exactly, up to the
/// order of sums and pivots, where every length of the input and the options is scaled.
inline constexpr double scales[] = {0.5, 2.0};
/// For what differs by the rounding of sums in double alone; lengths refer to the scale of the
/// result.
inline constexpr double rounding = 1e-6;

/// x ↦ scale · (motion · x).
struct Similarity {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  double scale = 1.0;

  Eigen::Vector3d point(const Eigen::Vector3d& p) const { return scale * (motion * p); }
  Eigen::Vector3d direction(const Eigen::Vector3d& d) const { return motion.linear() * d; }

  RotationAxis operator()(const RotationAxis& axis) const {
    return {point(axis.point), direction(axis.direction)};
  }
  ReflectionPlane operator()(const ReflectionPlane& plane) const {
    return {point(plane.point), direction(plane.normal)};
  }
  Plane operator()(const Plane& plane) const {
    const Eigen::Vector3d normal = direction(plane.normal);
    return {normal, scale * (plane.offset - normal.dot(motion.translation()))};
  }
  Points operator()(Points points) const {
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      const Eigen::Vector3d p = points.row(i).transpose().cast<double>();
      points.row(i) = point(p).cast<float>().transpose();
    }
    return points;
  }
  PointCloud operator()(PointCloud cloud) const {
    cloud.positions = (*this)(std::move(cloud.positions));
    for (Eigen::Index i = 0; i < cloud.normals.rows(); ++i) {
      const Eigen::Vector3d n = cloud.normals.row(i).transpose().cast<double>();
      cloud.normals.row(i) = direction(n).cast<float>().transpose();
    }
    return cloud;
  }
  ObjectAxis operator()(const ObjectAxis& axis) const {
    return {(*this)(axis.axis), axis.residual};
  }
  ObjectPlane operator()(const ObjectPlane& plane) const {
    return {(*this)(plane.plane), plane.residual};
  }
  template <class Symmetry>
  std::vector<Symmetry> operator()(std::vector<Symmetry> symmetries) const {
    for (Symmetry& symmetry : symmetries) symmetry = (*this)(symmetry);
    return symmetries;
  }
};

inline Similarity scaling_by(double scale) { return {Eigen::Isometry3d::Identity(), scale}; }

/// A random rotation and shift.
inline Similarity motion_of(std::uint32_t seed) {
  std::mt19937 generator(seed);
  return {random_motion(generator), 1.0};
}

/// Whether there are as many symmetries as expected and each of these has one within an angle and,
/// at `here`, a distance.
template <class Symmetry>
bool are_the_same(const std::vector<Symmetry>& found, const std::vector<Symmetry>& expected,
                  const Eigen::Vector3d& here, double angle, double distance) {
  const SameSymmetry same{here, angle, distance};
  return found.size() == expected.size() &&
         std::all_of(expected.begin(), expected.end(), [&](const Symmetry& e) {
           return std::any_of(found.begin(), found.end(),
                              [&](const Symmetry& f) { return same(f, e); });
         });
}

/// The axes of candidates, or their planes.
template <class Candidates>
std::vector<RotationAxis> axes_of(const Candidates& candidates) {
  std::vector<RotationAxis> axes;
  for (const auto& candidate : candidates) axes.push_back(candidate.axis);
  return axes;
}
template <class Candidates>
std::vector<ReflectionPlane> planes_of(const Candidates& candidates) {
  std::vector<ReflectionPlane> planes;
  for (const auto& candidate : candidates) planes.push_back(candidate.plane);
  return planes;
}

}  // namespace symscene::testing
