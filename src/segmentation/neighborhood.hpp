#pragma once

#include <optional>

#include "symscene/core/neighbors.hpp"
#include "symscene/segmentation/hypothesis.hpp"
#include "symscene/segmentation/neighborhood_options.hpp"

namespace symscene {

/// A part of a surface, with indices of its own.
struct LocalSurface {
  PointIndices points;  ///< into the whole cloud, ascending
  PointCloud cloud;
  std::vector<WeightedEdge> edges;  ///< those between points of the part

  /// Indices into the whole cloud of indices into the part, and back; those are all of the part.
  PointIndices in_whole(const PointIndices& local) const;
  PointIndices in_part(const PointIndices& whole) const;
};

/// Finds the part of a surface that the object of a hypothesis may reach, so that the time of a
/// cut does not grow with the scene.
class Neighborhoods {
 public:
  Neighborhoods(const ObservedSurface& surface, const NeighborhoodOptions& options);

  /// The points within the reach of the support's centroid: the farthest of its points times
  /// `options.reach`, plus `options.margin`. None if that is the whole cloud, or without support.
  std::optional<LocalSurface> around(const PointIndices& support) const;

 private:
  PointIndices points_around(const PointIndices& support) const;

  const PointCloud& cloud_;
  std::vector<WeightedEdge> edges_;  ///< by their first node, else in the order of the surface's
  std::vector<Index> first_edge_;    ///< N+1: the edges of i are [first_edge_[i], first_edge_[i+1])
  CellList cells_;
  NeighborhoodOptions options_;
};

}  // namespace symscene
