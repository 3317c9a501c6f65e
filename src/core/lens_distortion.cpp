#include "symscene/core/lens_distortion.hpp"

#include <cmath>

#include <Eigen/LU>

namespace symscene {
namespace {

/// The derivative of distorted() by the ray.
Eigen::Matrix2d derivative(const LensDistortion& lens, const Eigen::Vector2d& ray) {
  const double x = ray.x(), y = ray.y();
  const double r2 = ray.squaredNorm();
  const double radial = 1.0 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  // d radial / d r², times two.
  const double slope = 2.0 * (lens.k1 + r2 * (2.0 * lens.k2 + r2 * 3.0 * lens.k3));
  const double mixed = slope * x * y + 2.0 * (lens.p1 * x + lens.p2 * y);
  Eigen::Matrix2d J;
  J << radial + slope * x * x + 2.0 * lens.p1 * y + 6.0 * lens.p2 * x, mixed, mixed,
      radial + slope * y * y + 6.0 * lens.p1 * y + 2.0 * lens.p2 * x;
  return J;
}

}  // namespace

bool LensDistortion::is_none() const {
  return k1 == 0.0 && k2 == 0.0 && p1 == 0.0 && p2 == 0.0 && k3 == 0.0;
}

Eigen::Vector2d LensDistortion::distorted(const Eigen::Vector2d& ray) const {
  const double x = ray.x(), y = ray.y();
  const double r2 = ray.squaredNorm();
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  return {x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
          y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y};
}

std::optional<Eigen::Vector2d> LensDistortion::undistorted(const Eigen::Vector2d& shown) const {
  constexpr int most_steps = 30;
  constexpr double tolerance = 1e-12;
  Eigen::Vector2d ray = shown;
  for (int i = 0; i < most_steps; ++i) {
    const Eigen::Vector2d step =
        derivative(*this, ray).partialPivLu().solve(distorted(ray) - shown);
    if (!step.allFinite()) return std::nullopt;
    ray -= step;
    if (step.norm() < tolerance) return is_monotonic_to(ray) ? std::optional(ray) : std::nullopt;
  }
  return std::nullopt;
}

bool LensDistortion::is_monotonic_to(const Eigen::Vector2d& ray) const {
  constexpr int steps = 16;
  for (int i = 1; i <= steps; ++i) {
    const Eigen::Matrix2d J = derivative(*this, ray * (static_cast<double>(i) / steps));
    if (!(J.determinant() > 0.0) || !(J.trace() > 0.0)) return false;
  }
  return true;
}

}  // namespace symscene
