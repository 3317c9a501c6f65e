#include "symmetry_frame.hpp"

#include <cmath>

#include <Eigen/Dense>

#include "core/twist.hpp"

namespace symscene {
namespace {

constexpr int rounds = 8;
constexpr Index fit_points = 500;
constexpr std::size_t least_matches = 6;

/// Normal equations in the turn about the centre and its shift.
struct FrameEquations {
  Matrix6d matrix = Matrix6d::Zero();
  Vector6d right = Vector6d::Zero();
  double squares = 0.0;  ///< of the distances of images [m²]
  std::size_t matches = 0;

  void add(const Vector6d& gradient, double residual) {
    matrix += gradient * gradient.transpose();
    right -= residual * gradient;
  }
};

/// r = n' · (S(p) − p') with S(p) = p − 2 (n · q) n and q = p − c.
void add_mirror(const IndexedCloud& cloud, const PointIndices& sources, const SymmetryFrame& frame,
                int axis, double spacing, FrameEquations& equations) {
  const CorrespondenceOptions matching{.max_distance = 1.6 * spacing,
                                       .min_plane_distance = 2.0 * spacing};
  const Eigen::Vector3d n = frame.axes.col(axis);
  for (const Correspondence& match :
       one_to_one(reflect_onto(cloud, sources, frame.plane(axis), matching))) {
    const Eigen::Vector3d q = cloud.cloud.position(match.from).cast<double>() - frame.center;
    const Eigen::Vector3d target = cloud.cloud.position(match.to).cast<double>() - frame.center;
    const Eigen::Vector3d target_normal = cloud.cloud.normal(match.to).cast<double>();
    const double distance = n.dot(q);
    const double cosine = n.dot(target_normal);
    const double residual = target_normal.dot(q - 2.0 * distance * n - target);
    Vector6d gradient;
    gradient << -2.0 * (cosine * n.cross(q) + distance * n.cross(target_normal)), 2.0 * cosine * n;
    equations.add(gradient, residual);
    equations.squares += residual * residual;
    ++equations.matches;
  }
}

/// r = s n · (d × q) / |d × q|, with the spacing s as the unit of length.
void add_axis(const PointCloud& cloud, const PointIndices& sources, const SymmetryFrame& frame,
              double spacing, FrameEquations& equations) {
  const Eigen::Vector3d d = frame.axes.col(2);
  for (const Index i : sources) {
    const Eigen::Vector3d q = cloud.position(i).cast<double>() - frame.center;
    const Eigen::Vector3d n = cloud.normal(i).cast<double>();
    const double radius = d.cross(q).norm();
    if (radius < spacing) continue;
    const double scale = spacing / radius;
    const double sine = n.dot(d.cross(q)) / radius;
    const double weight = 1.0 / (1.0 + 10.0 * sine * sine);
    Vector6d gradient;
    gradient << scale * (n.dot(d) * q - d.dot(q) * n), -scale * n.cross(d);
    equations.add(weight * gradient, weight * spacing * sine);
  }
}

FrameEquations equations_of(const IndexedCloud& cloud, const PointIndices& sources,
                            const SymmetryFrame& frame, double spacing) {
  FrameEquations equations;
  for (int axis = 0; axis < 3; ++axis) {
    if (frame.mirrors[static_cast<std::size_t>(axis)])
      add_mirror(cloud, sources, frame, axis, spacing, equations);
  }
  if (frame.rotates) add_axis(cloud.cloud, sources, frame, spacing, equations);
  return equations;
}

}  // namespace

Eigen::Matrix3d frame_about(const Eigen::Vector3d& direction) {
  Eigen::Matrix3d axes;
  axes << orthonormal_complement(direction), direction;
  return axes;
}

SymmetryFrame fit_frame(const IndexedCloud& cloud, SymmetryFrame frame, double spacing) {
  const PointIndices sources = evenly_spread(cloud.cloud.size(), fit_points);
  for (int round = 0; round < rounds; ++round) {
    FrameEquations equations = equations_of(cloud, sources, frame, spacing);
    if (!frame.rotates && equations.matches < least_matches) break;
    frame.residual = equations.matches > 0
                         ? std::sqrt(equations.squares / static_cast<double>(equations.matches))
                         : 0.0;
    // Turns and shifts that nothing determines stay small.
    const auto weight = static_cast<double>(sources.size());
    equations.matrix.diagonal().head<3>().array() += 0.1 * weight * spacing * spacing;
    equations.matrix.diagonal().tail<3>().array() += 1e-3 * weight;
    const Vector6d step = equations.matrix.ldlt().solve(equations.right);
    if (!step.allFinite()) break;
    Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
    turn.linear() = frame.axes;
    Vector6d rotation = Vector6d::Zero();
    rotation.head<3>() = step.head<3>();
    frame.axes = orthonormal(motion(rotation) * turn).linear();
    frame.center += step.tail<3>();
    if (step.head<3>().norm() < 1e-4 && step.tail<3>().norm() < 0.01 * spacing) break;
  }
  return frame;
}

}  // namespace symscene
