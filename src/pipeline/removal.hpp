#pragma once

#include "segmentation/workspace.hpp"
#include "symscene/pipeline/pipeline_options.hpp"

namespace symscene {

/// The part of a workspace that is left when objects are removed. Its indices count in its own
/// cloud.
struct Remainder {
  PointCloud cloud;
  std::vector<WeightedEdge> edges;
  std::vector<PointIndices> segments;
  PointIndices original;  ///< one per point of `cloud`: its index in the whole cloud

  /// Indices into the whole cloud.
  PointIndices in_whole(const PointIndices& points) const;
};

/// Removes the points of rotational objects before the reflectional stream (section 4.4): of
/// hypotheses within the bounds whose confidence is at least `min_removal_score`. Less certain ones
/// may be a part of a larger reflectional object, such as the limb of a toy. Segments lose the
/// removed points; those left with too few are dropped.
Remainder without_rotational_objects(const Workspace& space,
                                     const std::vector<Hypothesis>& hypotheses,
                                     const PipelineOptions& options);

}  // namespace symscene
