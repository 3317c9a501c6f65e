#pragma once

#include <optional>
#include <vector>

#include "symscene/core/neighbors.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/segmentation/graph_cut.hpp"

namespace symscene {

/// The 5 mm cloud with its space and its surface: what both streams read.
struct Workspace {
  PointCloud cloud;
  DistanceField field;
  std::optional<Eigen::Vector3d> up;
  std::vector<WeightedEdge> edges;
  NeighborLists neighbors;  ///< of region growing: all within a voxel's diagonal
  std::vector<PointIndices> segments;
};

}  // namespace symscene
