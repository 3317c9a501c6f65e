#pragma once

#include <optional>

#include <Eigen/Core>

namespace symscene {

/// Radial and tangential distortion of a lens: D. C. Brown, "Close-range camera calibration",
/// Photogrammetric Engineering 37(8), 1971; the first five coefficients of OpenCV and "plumb_bob"
/// of ROS. Positions are those of rays with z = 1.
struct LensDistortion {
  double k1 = 0.0;  ///< radial, of r²
  double k2 = 0.0;  ///< radial, of r⁴
  double p1 = 0.0;  ///< tangential, along y
  double p2 = 0.0;  ///< tangential, along x
  double k3 = 0.0;  ///< radial, of r⁶

  bool is_none() const;

  /// Where the lens shows a ray, as the x and y of another ray.
  Eigen::Vector2d distorted(const Eigen::Vector2d& ray) const;

  /// The ray that the lens shows at a position, by Newton's method. None where the polynomial folds
  /// back, so that no ray or several would be shown there.
  std::optional<Eigen::Vector2d> undistorted(const Eigen::Vector2d& shown) const;

  /// Whether distorted() is one-to-one from the centre out to this ray.
  bool is_monotonic_to(const Eigen::Vector2d& ray) const;
};

}  // namespace symscene
