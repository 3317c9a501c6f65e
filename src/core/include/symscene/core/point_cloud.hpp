#pragma once

#include <limits>
#include <span>

#include "symscene/core/types.hpp"

namespace symscene {

/// Points with optional unit normals and colours, in one frame (the world frame unless the variable
/// is named otherwise).
struct PointCloud {
  Points positions;  ///< N×3 [m]
  Points normals;    ///< N×3 unit vectors that point out of the surface, or 0×3
  Colors colors;     ///< N×3, or 0×3

  Index size() const { return static_cast<Index>(positions.rows()); }
  bool empty() const { return positions.rows() == 0; }
  bool has_normals() const { return normals.rows() != 0; }
  bool has_colors() const { return colors.rows() != 0; }

  Eigen::Vector3f position(Index i) const { return positions.row(i).transpose(); }
  Eigen::Vector3f normal(Index i) const { return normals.row(i).transpose(); }
};

/// An axis-aligned box. [m]
struct Box {
  Eigen::Vector3f min = Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity());
  Eigen::Vector3f max = Eigen::Vector3f::Constant(-std::numeric_limits<float>::infinity());

  Eigen::Vector3f extent() const { return max - min; }
  Box padded(float margin) const { return {min.array() - margin, max.array() + margin}; }
};

/// Whether the surface bends outwards between two of its points with normals, seen from both ends:
/// (n₁ − n₂) · (p₁ − p₂) > 0.
inline bool bends_outwards(const PointCloud& cloud, Index a, Index b) {
  return (cloud.normal(a) - cloud.normal(b)).dot(cloud.position(a) - cloud.position(b)) > 0.0F;
}

/// The tight box around `points`; min > max where there is no point.
Box bounding_box(const Points& points);

/// The points of `cloud` at `indices`, in that order, with their normals and colours.
PointCloud select(const PointCloud& cloud, std::span<const Index> indices);

/// The mean of the points at `indices`, summed in double in the order given; zero if there is none.
/// [m]
Eigen::Vector3d centroid(const Points& points, std::span<const Index> indices);
Eigen::Vector3d centroid(const Points& points);

/// The principal axes of points about their centroid as columns, longest first; an arbitrary
/// basis if they have no extent.
Eigen::Matrix3d principal_axes(const Points& points);

/// The points with finite coordinates, ascending.
PointIndices finite_points(const Points& points);

/// The points with a unit normal, ascending.
PointIndices oriented_points(const PointCloud& cloud);

/// At most `count` of the indices 0 … size − 1, evenly spread, ascending.
PointIndices evenly_spread(Index size, Index count);

/// Intersection over union of two ascending index sets; zero if both are empty (Eq. 4.16).
double intersection_over_union(std::span<const Index> a, std::span<const Index> b);

/// Number of indices common to two ascending sets.
std::size_t intersection_size(std::span<const Index> a, std::span<const Index> b);

}  // namespace symscene
