#pragma once

#include "symscene/pipeline/pipeline.hpp"

namespace symscene {

/// The symmetries that a scene's smooth segments propose, before anything is cut out: what section
/// 3.6 evaluates. Planes are sought on the whole scene, rotational objects and all.
struct SceneDetections {
  PointCloud cloud;  ///< the 5 mm cloud that supports count in
  std::vector<RotationalCandidate> axes;
  std::vector<ReflectionalCandidate> planes;
};

/// Throws InputError as segment_scene() does.
SceneDetections detect_symmetries(const Scene& scene, const PipelineOptions& options = {},
                                  const StageTimer::OnBegin& on_begin = {});

}  // namespace symscene
