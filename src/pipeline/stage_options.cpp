#include "pipeline/stage_options.hpp"

namespace symscene {

WorkspaceOptions workspace_options(const PipelineOptions& options) {
  return {.voxel_size = options.voxel_size,
          .stray_radius = options.stray_radius,
          .stray_neighbors = options.stray_neighbors,
          .space_margin = options.space_margin,
          .frame_tolerance = options.frame_tolerance,
          .normals = options.normals,
          .outward_vote = options.outward_vote,
          .distance_field = options.distance_field,
          .oversegmentation = options.oversegmentation,
          .surface_graph = options.surface_graph};
}

RemovalOptions removal_options(const PipelineOptions& options) {
  return {.bounds = options.rotational_segmentation.bounds,
          .min_confidence = options.min_removal_confidence,
          .min_segment_size = options.oversegmentation.min_size};
}

}  // namespace symscene
