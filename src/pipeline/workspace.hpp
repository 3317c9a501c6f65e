#pragma once

#include "segmentation/workspace.hpp"
#include "symscene/pipeline/pipeline.hpp"

namespace symscene {

/// Samples the scene's cloud, maps the space around it and its surface. Warns of frames that do not
/// belong together. Throws InputError as segment_scene() does.
Workspace build_workspace(const Scene& scene, const PipelineOptions& options, StageTimer& timer);

/// The part of a workspace that a set of points does not cover, with where its points stand in the
/// whole. Its field and neighbours are left empty: they are the whole's.
struct Remainder {
  Workspace space;
  PointIndices original;
};

/// Removes the points of rotational cuts (section 4.4) that are within the bounds and certain
/// enough: the limb of a toy passes for a body of revolution now and then, and the toy needs it.
/// Segments are thinned, small leftovers dropped.
Remainder without_objects(const Workspace& space, const std::vector<Hypothesis>& cuts,
                          const PipelineOptions& options);

}  // namespace symscene
