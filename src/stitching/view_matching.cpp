#include "view_matching.hpp"

#include <cmath>

#include "surface_lookup.hpp"

namespace symscene {
namespace {

constexpr double surface_floor = 5e-4;  ///< deviation of a near surface: errors of the sensor [m]

Eigen::Vector3d normal_of(const SurfacePixel& pixel) {
  return {static_cast<double>(pixel.nx), static_cast<double>(pixel.ny),
          static_cast<double>(pixel.nz)};
}

/// Two pixels that show the same, in the camera's frame of the fixed one.
struct Match {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double residual = 0.0;   ///< along the normal, from the fixed to the moved point [m]
  double deviation = 0.0;  ///< of the residual [m]
};

/// The match of a point with the pixel onto which it falls.
bool find_match(const Eigen::Vector3d& point_fixed, const Eigen::Vector3d& normal_fixed,
                const SurfaceImage& fixed, const MatchGates& gates,
                const MeasurementOptions& sensor, Match& match) {
  constexpr double nearest = 0.05;  // [m]
  const std::optional<PixelPlace> place = find_pixel(fixed, point_fixed, nearest);
  if (!place) return false;
  const SurfacePixel& pixel = pixel_of(fixed, *place);
  match.normal = normal_of(pixel);
  const Eigen::Vector3d gap = point_fixed - point_of(fixed, *place);
  if (gap.squaredNorm() > gates.distance * gates.distance ||
      match.normal.dot(normal_fixed) < gates.cosine) {
    return false;
  }
  match.residual = match.normal.dot(gap);
  const auto seen = static_cast<double>(pixel.depth);
  match.deviation =
      surface_floor + std::hypot(sensor.deviation(point_fixed.z()), sensor.deviation(seen));
  return true;
}

void add(const Match& match, const Eigen::Vector3d& point_world, const Eigen::Matrix3d& R,
         double robust_sigmas, PairSystem& system) {
  const Eigen::Vector3d n = R * match.normal;
  Vector6d J;
  J << point_world.cross(n), n;
  const double ratio = match.residual / (robust_sigmas * match.deviation);
  const double weight = 1.0 / ((1.0 + ratio * ratio) * match.deviation * match.deviation);
  system.A.noalias() += (weight * J) * J.transpose();
  system.b += weight * match.residual * J;
  ++system.matches;
  if (std::abs(match.residual) > 3.0 * match.deviation) return;
  ++system.inliers;
  system.squares += match.residual * match.residual;
}

}  // namespace

PairSystem match_surfaces(const PlacedSurface& moved, const PlacedSurface& fixed,
                          const MatchGates& gates, const MeasurementOptions& sensor) {
  const Eigen::Isometry3d T = fixed.T_world_camera.inverse() * moved.T_world_camera;
  const Eigen::Matrix3d turn = T.linear();
  PairSystem system;
  Match match;
  for_each_surface_pixel(moved.image, [&](PixelPlace place, const SurfacePixel& pixel) {
    const Eigen::Vector3d point = T * point_of(moved.image, place);
    if (!find_match(point, turn * normal_of(pixel), fixed.image, gates, sensor, match)) return;
    add(match, fixed.T_world_camera * point, fixed.T_world_camera.linear(), gates.robust_sigmas,
        system);
  });
  return system;
}

PairSystem match_points(const PointPairs& pairs, const Eigen::Isometry3d& T_world_first,
                        const Eigen::Isometry3d& T_world_second,
                        const ViewAlignmentOptions& options) {
  PairSystem system;
  for (Eigen::Index i = 0; i < pairs.points_first.cols(); ++i) {
    const double z = std::max(pairs.points_first(2, i), pairs.points_second(2, i));
    const double deviation = options.point_deviation * std::max(1.0, z * z);
    const Eigen::Vector3d x = T_world_first * pairs.points_first.col(i);
    const Eigen::Vector3d e = x - T_world_second * pairs.points_second.col(i);
    const double bound = options.robust_sigmas * deviation;
    const double weight = 1.0 / ((1.0 + e.squaredNorm() / (bound * bound)) * deviation * deviation);
    const Eigen::Matrix<double, 3, 6> J = point_jacobian(x);
    system.A += weight * J.transpose() * J;
    system.b += weight * J.transpose() * e;
  }
  return system;
}

}  // namespace symscene
