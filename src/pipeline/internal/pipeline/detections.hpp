#pragma once

#include "symscene/pipeline/pipeline.hpp"

namespace symscene {

/// The symmetries that the smooth segments of a scene propose, before segmentation: the input of
/// the evaluation in section 3.6. Planes are detected on the whole scene, with rotational objects.
struct SceneDetections {
  PointCloud cloud;  ///< the sampled cloud that supports index
  std::vector<RotationalCandidate> axes;
  std::vector<ReflectionalCandidate> planes;  ///< of smooth segments (section 3.5.3)
  std::vector<EdgeCurve> curves;              ///< whose pairs propose planes too (section 3.4)
  DistanceField field;
  std::vector<std::string> warnings;  ///< one sentence each
};

/// Throws InputError as segment_scene() does.
SceneDetections detect_symmetries(const Scene& scene, const PipelineOptions& options = {},
                                  const StageTimer::OnBegin& on_begin = {});

}  // namespace symscene
