#include "symscene/reconstruction/trajectory_error.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/SVD>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

using Places = Eigen::Matrix3Xd;

Places places_of(std::span<const Eigen::Isometry3d> poses) {
  Places places(3, static_cast<Eigen::Index>(poses.size()));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    places.col(static_cast<Eigen::Index>(i)) = poses[i].translation();
  }
  return places;
}

/// Residual distances after rigid alignment (Umeyama 1991).
Eigen::VectorXd distances_when_aligned(const Places& estimated, const Places& truth) {
  const Eigen::Matrix4d T = Eigen::umeyama(estimated, truth, false);
  return (((T.topLeftCorner<3, 3>() * estimated).colwise() + T.topRightCorner<3, 1>()) - truth)
      .colwise()
      .norm()
      .transpose();
}

/// The difference of the motions from pose i to pose k.
Eigen::Isometry3d motion_error(std::span<const Eigen::Isometry3d> estimated,
                               std::span<const Eigen::Isometry3d> truth, std::size_t i,
                               std::size_t k) {
  return (truth[i].inverse() * truth[k]).inverse() * (estimated[i].inverse() * estimated[k]);
}

}  // namespace

TrajectoryError trajectory_error(std::span<const Eigen::Isometry3d> estimated,
                                 std::span<const Eigen::Isometry3d> truth, std::size_t interval) {
  if (estimated.size() != truth.size()) {
    throw InputError("trajectory", std::to_string(truth.size()) + " poses",
                     std::to_string(estimated.size()));
  }
  TrajectoryError error;
  error.poses = truth.size();
  if (truth.size() < 2) return error;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    error.length += (truth[i].translation() - truth[i - 1].translation()).norm();
  }
  const Eigen::VectorXd distances = distances_when_aligned(places_of(estimated), places_of(truth));
  error.absolute = std::sqrt(distances.squaredNorm() / static_cast<double>(distances.size()));
  error.absolute_max = distances.maxCoeff();
  error.drift = motion_error(estimated, truth, 0, truth.size() - 1).translation().norm();
  const std::size_t step = std::clamp<std::size_t>(interval, 1, truth.size() - 1);
  error.interval = step;
  double squares = 0.0, squared_angles = 0.0;
  for (std::size_t i = 0; i + step < truth.size(); ++i) {
    const Eigen::Isometry3d difference = motion_error(estimated, truth, i, i + step);
    squares += difference.translation().squaredNorm();
    squared_angles += std::pow(Eigen::AngleAxisd(difference.linear()).angle(), 2);
  }
  const auto count = static_cast<double>(truth.size() - step);
  error.relative = std::sqrt(squares / count);
  error.relative_angle = std::sqrt(squared_angles / count);
  return error;
}

}  // namespace symscene
