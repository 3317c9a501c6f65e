#pragma once

#include "symscene/core/scene.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/pipeline/pipeline_options.hpp"

namespace symscene {

/// Adds the hidden points of every object, its centre of mass, its closed surface and its box.
void complete_objects(const DistanceField& field, const PipelineOptions& options,
                      SegmentationResult& result);

}  // namespace symscene
