#pragma once

#include "boundary_points.hpp"

namespace symscene {

/// A path over nodes with the distance of every point from its start along it.
class MeasuredPath {
 public:
  MeasuredPath(const BoundaryNodes& nodes, PointIndices path);

  std::size_t size() const { return path_.size(); }
  double length() const { return along_.empty() ? 0.0 : along_.back(); }
  const Eigen::Vector3d& position(std::size_t k) const { return nodes_[path_[k]].position; }
  const PointIndices& path() const { return path_; }

  /// The direction of the line of least squares through the points within `reach` of `k` along the
  /// path.
  Eigen::Vector3d tangent(std::size_t k, double reach) const;

  /// How far the path turns at `k`, over `reach` on both sides; zero near its ends, where it is not
  /// known. [rad]
  double turn(std::size_t k, double reach) const;

  /// The directions in which the path leaves its start and its end, over `reach`.
  Eigen::Vector3d direction_at_start(double reach) const;
  Eigen::Vector3d direction_at_end(double reach) const;

  PointIndices part(std::size_t begin, std::size_t end) const;

 private:
  /// The point at a distance from the start along the path.
  Eigen::Vector3d position_at(double along) const;

  const BoundaryNodes& nodes_;
  PointIndices path_;
  std::vector<double> along_;
};

}  // namespace symscene
