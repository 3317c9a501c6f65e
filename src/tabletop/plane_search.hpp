#pragma once

#include <vector>

#include "symscene/tabletop/table_scene.hpp"

namespace symscene {

/// The planes with most inliers in a sample, one after the other, each without the inliers of those
/// before. Their normals point to the same side as those of the points.
std::vector<Plane> dominant_planes(const PointCloud& cloud, const PointIndices& usable,
                                   const SupportPlaneOptions& options);

/// Sums of points, for the plane of least squared distances.
class PlaneMoments {
 public:
  void add(const Eigen::Vector3d& point) {
    ++count_;
    sum_ += point;
    squares_ += point * point.transpose();
  }
  PlaneMoments operator+(const PlaneMoments& other) const;

  std::size_t count() const { return count_; }
  /// Its normal points to the side of that of `fallback`, which it returns where the points do not
  /// span a plane.
  Plane plane(const Plane& fallback) const;
  /// Root mean square distance of the points from a plane. [m]
  double residual(const Plane& plane) const;

 private:
  std::size_t count_ = 0;
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares_ = Eigen::Matrix3d::Zero();
};

}  // namespace symscene
