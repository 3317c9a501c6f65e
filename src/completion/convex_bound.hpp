#pragma once

#include <limits>
#include <vector>

#include <Eigen/Core>

#include "node_grid.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// Intersection of half spaces that holds a set of points; approximates their convex hull.
class ConvexBound {
 public:
  /// `directions` are outward unit normals; others, evenly spread, are added to them.
  ConvexBound(std::vector<Eigen::Vector3f> directions, const Points& points);

  /// The least extent of the points along one of the directions. [m]
  float least_width() const { return least_width_; }

  /// How far a ray from a point inside goes until it leaves the bound. [m]
  float exit_distance(const Eigen::Vector3f& point, const Eigen::Vector3f& direction) const;

  /// At every node the largest signed distance from the half spaces, negative inside; at least
  /// `margin` for nodes that are farther outside. [m]
  std::vector<float> distances(const NodeGrid& grid, float margin) const;

 private:
  /// The nodes [begin, end) of a row.
  struct Interval {
    float begin = 0.0F, end = 0.0F;
  };

  /// Those of a row of `count` nodes from `start` along x that may be within `margin`.
  Interval within(const Eigen::Vector3f& start, float spacing, float count, float margin) const;

  std::vector<Eigen::Vector3f> directions_;
  std::vector<float> offsets_;  ///< p·d of the farthest point along each direction [m]
  float least_width_ = std::numeric_limits<float>::max();  ///< [m]
};

}  // namespace symscene
