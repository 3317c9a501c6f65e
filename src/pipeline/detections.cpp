#include "pipeline/detections.hpp"

#include "pipeline/stage_options.hpp"
#include "planes.hpp"

namespace symscene {

SceneDetections detect_symmetries(const Scene& scene, const PipelineOptions& options,
                                  const StageTimer::OnBegin& on_begin) {
  options.validate();
  StageTimer timer(on_begin);
  Workspace space = build_workspace(scene, workspace_options(options), timer);
  SceneDetections detections;
  detections.axes = timer.time("rotational detection", [&] {  // section 3.5.2
    return detect_rotational(space.cloud, space.segments, space.field, space.up,
                             options.rotational_detection)
        .candidates;
  });
  detections.planes = timer.time("reflectional detection", [&] {  // section 3.5.3
    return detect_reflectional(space.cloud, space.segments, space.field, space.up,
                               options.reflectional_detection)
        .candidates;
  });
  detections.curves =
      timer.time("edge curves", [&] { return scene_curves(space.cloud, options); });  // 3.4.1
  detections.cloud = std::move(space.cloud);
  detections.field = std::move(space.field);
  detections.warnings = std::move(space.warnings);
  return detections;
}

}  // namespace symscene
