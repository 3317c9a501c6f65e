#pragma once

#include "pipeline/detections.hpp"
#include "symscene/evaluation/sweep.hpp"
#include "symscene/ground_truth/scene_truth.hpp"

namespace symscene {

/// The sweeps of table 3.1 over the symmetries before segmentation: axes, planes of smooth
/// segments, planes of curves.
std::vector<Sweep> detection_sweeps(const Scene& scene, const SceneTruth& truth,
                                    const PipelineOptions& options,
                                    const StageTimer::OnBegin& on_begin);

}  // namespace symscene
