#pragma once

#include <optional>
#include <string>
#include <vector>

#include "symscene/core/neighbors.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/segmentation/graph_cut.hpp"
#include "symscene/segmentation/hypothesis.hpp"

namespace symscene {

/// The sampled cloud with the space around it and the structure of its surface: the input of both
/// streams. World frame.
struct Workspace {
  PointCloud cloud;  ///< one point per voxel, with unit normals
  DistanceField field;
  std::optional<Eigen::Vector3d> up;   ///< unit normal of the table, where known
  std::vector<WeightedEdge> edges;     ///< the surface graph of `cloud`
  NeighborLists neighbors;             ///< for region growing: within the diagonal of a voxel
  std::vector<PointIndices> segments;  ///< smooth segments, largest first
  std::vector<std::string> warnings;   ///< one sentence each

  ObservedSurface surface() const { return {cloud, edges, field}; }
};

}  // namespace symscene
