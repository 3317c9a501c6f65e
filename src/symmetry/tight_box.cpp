#include "tight_box.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "group_search.hpp"
#include "symmetry/greatest_distance.hpp"

namespace symscene {
namespace {

double width(const Points& points, const Eigen::Vector3d& direction) {
  const Eigen::VectorXf along = points * direction.cast<float>();
  return double{along.maxCoeff()} - double{along.minCoeff()};
}

Eigen::Vector3d narrowest(const Points& points, const std::vector<Eigen::Vector3d>& directions) {
  Eigen::Vector3d best = directions.front();
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& direction : directions) {
    const double each = width(points, direction);
    if (each >= least) continue;
    least = each;
    best = direction;
  }
  return best;
}

/// A direction and those around it at an angle.
std::vector<Eigen::Vector3d> around(const Eigen::Vector3d& direction, double angle) {
  std::vector<Eigen::Vector3d> directions{direction};
  const Eigen::Matrix<double, 3, 2> basis = orthonormal_complement(direction);
  constexpr int sides = 12;
  for (int k = 0; k < sides; ++k) {
    const double turn = 2.0 * std::numbers::pi * k / sides;
    const Eigen::Vector3d side = basis * Eigen::Vector2d(std::cos(turn), std::sin(turn));
    directions.push_back((direction + std::tan(angle) * side).normalized());
  }
  return directions;
}

Eigen::Vector3d narrowest_of_all(const Points& points) {
  Eigen::Vector3d best = narrowest(points, hemisphere(1000));
  for (double angle = radians(3.0); angle > radians(0.1); angle /= 2.0)
    best = narrowest(points, around(best, angle));
  return best;
}

std::vector<Eigen::Vector3d> directions_across(const Eigen::Vector3d& axis) {
  constexpr int steps = 360;
  const Eigen::Matrix<double, 3, 2> basis = orthonormal_complement(axis);
  std::vector<Eigen::Vector3d> directions;
  for (int k = 0; k < steps; ++k) {
    const double turn = std::numbers::pi * k / steps;
    directions.emplace_back(basis * Eigen::Vector2d(std::cos(turn), std::sin(turn)));
  }
  return directions;
}

}  // namespace

double tight_box_diagonal(const Points& points) {
  if (points.rows() == 0) return 0.0;
  const Points outermost = points(outermost_points(points), Eigen::all);
  const Eigen::Vector3d first = narrowest_of_all(outermost);
  const Eigen::Vector3d second = narrowest(outermost, directions_across(first));
  const Eigen::Vector3d third = first.cross(second);
  return std::hypot(width(outermost, first), width(outermost, second), width(outermost, third));
}

}  // namespace symscene
