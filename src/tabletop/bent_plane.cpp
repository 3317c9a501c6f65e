#include "bent_plane.hpp"

#include <cmath>

#include <Eigen/Cholesky>

namespace symscene {
namespace {

constexpr std::size_t least_points = 100;

}  // namespace

BentPlane::BentPlane(const Plane& plane, const PointCloud& cloud, const PointIndices& points)
    : frame_(plane) {
  if (points.size() < least_points) return;
  const auto at = [&](Index i) -> Eigen::Vector3d { return cloud.position(i).cast<double>(); };
  double squares = 0.0;
  for (const Index i : points) center_ += frame_.within(at(i));
  center_ /= static_cast<double>(points.size());
  for (const Index i : points) squares += (frame_.within(at(i)) - center_).squaredNorm();
  scale_ = std::sqrt(squares / static_cast<double>(points.size()));
  if (!(scale_ > 1e-6)) {
    scale_ = 1.0;
    return;
  }
  Eigen::Matrix<double, 6, 6> normal_matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Terms right = Terms::Zero();
  for (const Index i : points) {
    const Terms row = terms(at(i));
    normal_matrix += row * row.transpose();
    right += row * plane.signed_distance(at(i));
  }
  const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> solver(normal_matrix);
  constexpr double least_pivot = 1e-4;
  const bool determined =
      solver.vectorD().minCoeff() > least_pivot * static_cast<double>(points.size());
  if (determined) coefficients_ = solver.solve(right);
}

double BentPlane::residual(const PointCloud& cloud, const PointIndices& points) const {
  if (points.empty()) return 0.0;
  double squares = 0.0;
  for (const Index i : points) {
    const double distance = height(cloud.position(i).cast<double>());
    squares += distance * distance;
  }
  return std::sqrt(squares / static_cast<double>(points.size()));
}

}  // namespace symscene
