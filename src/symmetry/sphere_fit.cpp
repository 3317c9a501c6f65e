#include "sphere_fit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "nearest_point.hpp"
#include "symscene/core/geometry.hpp"

namespace symscene {
namespace {

/// The point nearest to the lines of all normals: Σ (I − n nᵀ)(p − c) = 0. Where these are parallel
/// it is near the centroid of the points, wherever they are.
Eigen::Vector3d meeting_point_of_normals(const PointCloud& cloud) {
  NearestPoint meeting(centroid(cloud.positions), 1e-9);
  for (Index i = 0; i < cloud.size(); ++i)
    meeting.add_line(cloud.position(i).cast<double>(), cloud.normal(i).cast<double>());
  return meeting.solve();
}

}  // namespace

double distance_off_sphere(const Points& points) {
  constexpr double max_radius = 2.0;  // in diagonals of the points: beyond, they are nearly flat
  const Eigen::Vector3d center = centroid(points);
  Eigen::Matrix4d normal_matrix = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3d p = points.row(i).transpose().cast<double>() - center;
    const Eigen::Vector4d row(2.0 * p.x(), 2.0 * p.y(), 2.0 * p.z(), 1.0);
    normal_matrix += row * row.transpose();
    right += p.squaredNorm() * row;
  }
  const Eigen::Vector4d fit = normal_matrix.ldlt().solve(right);
  const Eigen::Vector3d middle = fit.head<3>();
  const double radius = std::sqrt(std::max(0.0, fit.w() + middle.squaredNorm()));
  const auto diagonal = static_cast<double>(bounding_box(points).extent().norm());
  if (!(radius > 0.0) || !(radius <= max_radius * diagonal)) return 1.0;
  double sum = 0.0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3d p = points.row(i).transpose().cast<double>() - center;
    sum += std::abs((p - middle).norm() - radius);
  }
  return std::min(1.0, sum / (static_cast<double>(points.rows()) * radius));
}

std::optional<Eigen::Vector3d> sphere_center(const PointCloud& cloud,
                                             const SphereOptions& options) {
  const Eigen::Vector3d center = meeting_point_of_normals(cloud);
  double angles = 0.0;
  double radii = 0.0;
  double squared_radii = 0.0;
  for (Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d radius = cloud.position(i).cast<double>() - center;
    angles += line_angle(radius, cloud.normal(i).cast<double>());
    radii += radius.norm();
    squared_radii += radius.squaredNorm();
  }
  const auto count = static_cast<double>(cloud.size());
  const double mean = radii / count;
  const double deviation = std::sqrt(std::max(0.0, squared_radii / count - mean * mean));
  const bool is_sphere =
      angles / count < options.max_angle && deviation < options.max_radius_deviation * mean;
  return is_sphere ? std::optional(center) : std::nullopt;
}

}  // namespace symscene
