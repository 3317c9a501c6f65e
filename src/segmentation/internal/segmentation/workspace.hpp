#pragma once

#include <optional>
#include <string>
#include <vector>

#include "symscene/core/neighbors.hpp"
#include "symscene/core/normal_estimation.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/occupancy/outward_vote.hpp"
#include "symscene/segmentation/graph_cut.hpp"
#include "symscene/segmentation/hypothesis.hpp"
#include "symscene/segmentation/oversegmentation.hpp"
#include "symscene/segmentation/surface_graph.hpp"

namespace symscene {

/// The sampled cloud with the space around it and the structure of its surface: the input of both
/// streams. World frame.
struct Workspace {
  PointCloud cloud;  ///< one point per voxel, with unit normals
  DistanceField field;
  std::optional<Eigen::Vector3d> up;   ///< unit normal of the table, where known
  std::vector<WeightedEdge> edges;     ///< the surface graph of `cloud`
  NeighborLists neighbors;             ///< voxel_neighbors(), for region growing
  std::vector<PointIndices> segments;  ///< smooth segments, largest first
  std::vector<std::string> warnings;   ///< one sentence each

  ObservedSurface surface() const { return {cloud, edges, field}; }
};

/// Options of the stages that prepare a scene, declared in PipelineOptions.
struct WorkspaceOptions {
  double voxel_size = 0.0;    ///< [m]
  double stray_radius = 0.0;  ///< [m]
  int stray_neighbors = 0;
  double space_margin = 0.0;     ///< [m]
  double frame_tolerance = 0.0;  ///< [m]
  NormalEstimationOptions normals;
  OutwardVoteOptions outward_vote;
  DistanceFieldOptions distance_field;
  OversegmentationOptions oversegmentation;
  SurfaceGraphOptions surface_graph;
};

/// For every point of a cloud of one point per voxel the others within the diagonal of a voxel.
NeighborLists voxel_neighbors(const Points& points, double voxel_size);

/// Samples the cloud of a scene (section 2.1.1), drops stray points, computes the distance field
/// (2.1.2) and completes the normals: the workspace without the structure of its surface. Its
/// warnings begin with the scene's. Throws InputError if the cloud has no finite point or spans
/// more space than memory holds.
Workspace sampled_workspace(const Scene& scene, const WorkspaceOptions& options, StageTimer& timer);

/// Prepares a scene for both streams: sampled_workspace() with the surface graph (4.3.2) and the
/// smooth segments (3.5.1).
Workspace build_workspace(const Scene& scene, const WorkspaceOptions& options, StageTimer& timer);

}  // namespace symscene
