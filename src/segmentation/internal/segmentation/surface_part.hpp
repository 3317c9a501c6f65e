#pragma once

#include <vector>

#include "symscene/core/point_cloud.hpp"
#include "symscene/segmentation/graph_cut.hpp"

namespace symscene {

/// A part of a cloud and of its surface graph. Their indices count in the part.
struct SurfacePart {
  PointIndices original;  ///< one per point of `cloud`, ascending: its index in the whole cloud
  PointCloud cloud;
  std::vector<WeightedEdge> edges;  ///< those between points of the part

  /// Indices into the whole cloud of indices into the part.
  PointIndices in_whole(const PointIndices& local) const;
  /// Indices into the part of indices into the whole cloud; those of other points are left out.
  PointIndices in_part(const PointIndices& whole) const;
};

/// Where the points of a part stand in it.
class PartPlaces {
 public:
  /// `points` are indices into a cloud of `count` points, ascending.
  PartPlaces(std::size_t count, const PointIndices& points);

  /// Appends an edge of the whole graph, in the part's indices, if the part holds both ends.
  void append(const WeightedEdge& edge, std::vector<WeightedEdge>& edges) const {
    if (place_[edge.a] != absent && place_[edge.b] != absent)
      edges.push_back({place_[edge.a], place_[edge.b], edge.weight});
  }

 private:
  static constexpr Index absent = ~Index{0};

  std::vector<Index> place_;  ///< one per point of the whole cloud, or `absent`
};

}  // namespace symscene
