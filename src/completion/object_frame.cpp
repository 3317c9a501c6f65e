#include "object_frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/as_rows.hpp"

namespace symscene {
namespace {

constexpr Index sampled_points = 1000;
constexpr int rectangle_steps = 30;  // of 3 degrees

Points sample_of(const SurfacePoints& points) {
  const PointIndices chosen = evenly_spread(static_cast<Index>(points.size()), sampled_points);
  return as_rows(chosen, [&](Index i) { return points.positions[i]; });
}

/// The area of the rectangle along two directions that holds the points. [m²]
double rectangle_area(const Points& points, const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  const auto extent = [&](const Eigen::Vector3d& direction) {
    const Eigen::VectorXf along = points * direction.cast<float>();
    return double{along.maxCoeff()} - double{along.minCoeff()};
  };
  return extent(u) * extent(v);
}

}  // namespace

Eigen::Matrix3d object_frame(const SurfacePoints& points, const std::optional<Plane>& table) {
  const Points sample = sample_of(points);
  const Eigen::Vector3d up = table ? table->normal : Eigen::Vector3d(principal_axes(sample).col(0));
  const Eigen::Matrix<double, 3, 2> across = orthonormal_complement(up);
  Eigen::Matrix3d frame;
  double least = std::numeric_limits<double>::max();
  for (int step = 0; step < rectangle_steps; ++step) {
    const double angle = radians(90.0 * step / rectangle_steps);
    const Eigen::Vector3d u = across * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const Eigen::Vector3d v = up.cross(u);
    const double area = rectangle_area(sample, u, v);
    if (area >= least) continue;
    least = area;
    frame << u, v, up;
  }
  return frame;
}

SurfacePoints turned(SurfacePoints points, const Eigen::Matrix3d& R_target_source) {
  const Eigen::Matrix3f turn = R_target_source.cast<float>();
  for (Eigen::Vector3f& position : points.positions) position = turn * position;
  for (Eigen::Vector3f& normal : points.normals) normal = turn * normal;
  return points;
}

}  // namespace symscene
