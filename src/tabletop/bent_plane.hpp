#pragma once

#include "plane_patch.hpp"

namespace symscene {

/// Heights above a plane plus a quadratic polynomial, as drift of the reconstruction bends tables.
class BentPlane {
 public:
  /// The plane itself.
  explicit BentPlane(const Plane& plane) : frame_(plane) {}
  /// Fitted to the points by least squares; the plane itself where they do not determine it.
  BentPlane(const Plane& plane, const PointCloud& cloud, const PointIndices& points);

  const PlaneFrame& frame() const { return frame_; }
  double height(const Eigen::Vector3d& point) const {
    return frame_.plane().signed_distance(point) - terms(point).dot(coefficients_);
  }
  /// Root mean square of the points' heights. [m]
  double residual(const PointCloud& cloud, const PointIndices& points) const;

 private:
  using Terms = Eigen::Matrix<double, 6, 1>;
  Terms terms(const Eigen::Vector3d& point) const {
    const Eigen::Vector2d at = (frame_.within(point) - center_) / scale_;
    Terms result;
    result << 1.0, at.x(), at.y(), at.x() * at.x(), at.x() * at.y(), at.y() * at.y();
    return result;
  }

  PlaneFrame frame_;
  Eigen::Vector2d center_ = Eigen::Vector2d::Zero();
  double scale_ = 1.0;
  Terms coefficients_ = Terms::Zero();
};

}  // namespace symscene
