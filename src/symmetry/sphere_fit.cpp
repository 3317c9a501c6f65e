#include "sphere_fit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "symscene/core/point_cloud.hpp"

namespace symscene {

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

}  // namespace symscene
