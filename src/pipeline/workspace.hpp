#pragma once

#include "segmentation/workspace.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/pipeline/pipeline_options.hpp"

namespace symscene {

/// Prepares a scene for both streams: samples its cloud (section 2.1.1), drops stray points,
/// computes the distance field (2.1.2), completes the normals, and builds the surface graph (4.3.2)
/// and the smooth segments (3.5.1). Its warnings begin with the scene's. Throws InputError as
/// segment_scene() does.
Workspace build_workspace(const Scene& scene, const PipelineOptions& options, StageTimer& timer);

}  // namespace symscene
