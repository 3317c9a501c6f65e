#pragma once

#include "segmentation/workspace.hpp"
#include "symscene/pipeline/pipeline_options.hpp"

namespace symscene {

/// The surface in which reflection planes are detected: a workspace, or what is left of it.
struct PlaneInput {
  const PointCloud& cloud;
  const std::vector<PointIndices>& segments;
  const DistanceField& field;
  const std::optional<Eigen::Vector3d>& up;  ///< unit normal of the table, where known
};

/// The curves along the edges of a cloud of one point per voxel (section 3.4.1).
std::vector<EdgeCurve> scene_curves(const PointCloud& cloud, const PipelineOptions& options);

/// The planes of smooth segments (section 3.5.3), then those of pairs of curves (3.4.2) that repeat
/// none of them, each if the options ask for it.
ReflectionalDetection detect_planes(const PlaneInput& input, const PipelineOptions& options);

}  // namespace symscene
