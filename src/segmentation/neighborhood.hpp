#pragma once

#include <optional>

#include "segmentation/surface_part.hpp"
#include "symscene/core/neighbors.hpp"
#include "symscene/segmentation/hypothesis.hpp"
#include "symscene/segmentation/neighborhood_options.hpp"

namespace symscene {

/// Finds the part of a surface that the object of a hypothesis may reach, so that the time of a
/// cut does not grow with the scene.
class Neighborhoods {
 public:
  Neighborhoods(const ObservedSurface& surface, const NeighborhoodOptions& options);

  /// The points within the reach of the support's centroid: the farthest of its points times
  /// `options.reach`, plus `options.margin`. None if that is the whole cloud, or without support.
  std::optional<SurfacePart> around(const PointIndices& support) const;

 private:
  PointIndices points_around(const PointIndices& support) const;

  const PointCloud& cloud_;
  std::vector<WeightedEdge> edges_;  ///< by their first node, else in the order of the surface's
  std::vector<Index> first_edge_;    ///< N+1: the edges of i are [first_edge_[i], first_edge_[i+1])
  CellList cells_;
  NeighborhoodOptions options_;
};

}  // namespace symscene
