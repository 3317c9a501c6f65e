#include "wall_view.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "core/median.hpp"

namespace symscene {
namespace {

constexpr double deviations = 3.0;           ///< within which a sample is on the plane
constexpr double least_tolerance = 0.001;    ///< over depth, so that exact data lose no sample
constexpr double normal_deviation = 1.4826;  ///< standard deviation over median absolute one

}  // namespace

std::vector<float> errors_of(const WallView& view, const DepthCorrection& grid,
                             const InverseDepthPlane& plane, const CameraIntrinsics& camera) {
  std::vector<float> errors;
  errors.reserve(view.samples.size());
  for (const DepthSample& s : view.samples) {
    const double z = s.depth * grid.factor(s.u, s.v, s.depth);
    errors.push_back(static_cast<float>(plane.error(camera.ray(s.u, s.v), z)));
  }
  return errors;
}

double tolerance_of(std::vector<float> errors) {
  for (float& error : errors) error = std::abs(error);
  return std::max(least_tolerance,
                  deviations * normal_deviation * median(std::move(errors)).value_or(0.0F));
}

double root_mean_square(const std::vector<float>& errors, double tolerance) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const float error : errors) {
    if (std::abs(error) > tolerance) continue;
    sum += double{error} * error;
    ++count;
  }
  return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
}

InverseDepthPlane refitted(const WallView& view, const DepthCorrection& grid,
                           const InverseDepthPlane& plane, double tolerance,
                           const CameraIntrinsics& camera) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (const DepthSample& s : view.samples) {
    const Eigen::Vector3d ray = camera.ray(s.u, s.v);
    const double z = s.depth * grid.factor(s.u, s.v, s.depth);
    if (std::abs(plane.error(ray, z)) > tolerance) continue;
    A += ray * ray.transpose();
    b += ray / z;
  }
  const Eigen::Vector3d coefficients = A.ldlt().solve(b);
  return coefficients.allFinite() ? InverseDepthPlane{coefficients} : plane;
}

}  // namespace symscene
