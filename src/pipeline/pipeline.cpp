#include "symscene/pipeline/pipeline.hpp"

#include "pipeline/object_completion.hpp"
#include "pipeline/stage_options.hpp"
#include "planes.hpp"
#include "proposals/object_proposals.hpp"

namespace symscene {
namespace {

void append(const std::vector<FunnelStep>& steps, std::vector<FunnelStep>& funnel) {
  funnel.insert(funnel.end(), steps.begin(), steps.end());
}

/// What a stream finds: candidates of its symmetries, and the hypotheses that they cut out.
struct RotationalStream {
  RotationalDetection axes;
  std::vector<Hypothesis> hypotheses;
};
struct ReflectionalStream {
  ReflectionalDetection planes;
  SegmentedHypotheses segmented;
};

RotationalStream rotational_stream(const Workspace& space, const PipelineOptions& options,
                                   StageTimer& timer) {
  RotationalStream stream;
  if (!options.rotational_stream) return stream;
  stream.axes = timer.time("rotational detection", [&] {  // section 3.5.2
    return detect_rotational(space.cloud, space.segments, space.field, space.up,
                             options.rotational_detection);
  });
  stream.hypotheses = timer.time("rotational segmentation", [&] {  // section 4.3.1.1
    return segment_rotational(space.surface(), stream.axes.candidates, options.rotational_detection,
                              options.rotational_segmentation);
  });
  return stream;
}

/// Turns indices into the remainder into indices into the whole cloud.
void index_whole_cloud(const Remainder& rest, ReflectionalStream& stream) {
  for (auto& candidate : stream.planes.candidates)
    candidate.support = rest.in_whole(candidate.support);
  for (auto& hypothesis : stream.segmented.hypotheses)
    hypothesis.points = rest.in_whole(hypothesis.points);
  for (auto& rejection : stream.segmented.rejected)
    rejection.points = rest.in_whole(rejection.points);
}

/// Among the points that the rotational stream left.
ReflectionalStream reflectional_stream(const Workspace& space, const Remainder& rest,
                                       const PipelineOptions& options, StageTimer& timer) {
  ReflectionalStream stream;
  stream.planes = timer.time("reflectional detection", [&] {  // sections 3.4, 3.5.3
    return detect_planes({rest.cloud, rest.segments, space.field, space.up}, options);
  });
  stream.segmented = timer.time("reflectional segmentation", [&] {  // section 4.3.1.2
    return segment_reflectional({rest.cloud, rest.edges, space.field}, stream.planes.candidates,
                                options.reflectional_detection.fit,
                                options.reflectional_segmentation);
  });
  index_whole_cloud(rest, stream);
  return stream;
}

std::vector<FunnelStep> funnel_of(const Scene& scene, const Workspace& space,
                                  const RotationalDetection& axes,
                                  const ReflectionalDetection& planes, std::size_t proposals) {
  std::vector<FunnelStep> funnel = {{"points", scene.cloud.size()},
                                    {"points at the working spacing", space.cloud.size()},
                                    {"smooth segments", space.segments.size()}};
  append(axes.funnel, funnel);
  append(planes.funnel, funnel);
  funnel.push_back({"distinct proposals", proposals});
  return funnel;
}

}  // namespace

SceneProposals propose_objects(const Scene& scene, const PipelineOptions& options,
                               const StageTimer::OnBegin& on_begin) {
  options.validate();
  StageTimer timer(on_begin);
  Workspace space = build_workspace(scene, workspace_options(options), timer);  // 2.1, 3.5.1, 4.3.2
  RotationalStream rotational = rotational_stream(space, options, timer);       // 3.5.2, 4.3.1.1
  const Remainder rest = timer.time("removal of rotational objects", [&] {      // section 4.4
    return without_rotational_objects(space, rotational.hypotheses, removal_options(options));
  });
  ReflectionalStream reflectional =
      reflectional_stream(space, rest, options, timer);                // 3.4, 3.5.3, 4.3.1.2
  std::vector<ObjectProposal> objects = timer.time("proposals", [&] {  // sections 4.3.3 and 4.4
    return object_proposals(space, rotational.hypotheses, reflectional.segmented.hypotheses,
                            options.proposal_options());
  });
  std::vector<FunnelStep> funnel =
      funnel_of(scene, space, rotational.axes, reflectional.planes, objects.size());
  return {.cloud = std::move(space.cloud),
          .table = scene.table,
          .field = std::move(space.field),
          .axes = std::move(rotational.axes.candidates),
          .planes = std::move(reflectional.planes.candidates),
          .rotational = std::move(rotational.hypotheses),
          .reflectional = std::move(reflectional.segmented.hypotheses),
          .rejected = std::move(reflectional.segmented.rejected),
          .objects = std::move(objects),
          .funnel = std::move(funnel),
          .timings = timer.stages(),
          .warnings = std::move(space.warnings)};
}

SegmentationResult segment_scene(const Scene& scene, const PipelineOptions& options,
                                 const StageTimer::OnBegin& on_begin) {
  const SceneProposals proposals = propose_objects(scene, options, on_begin);
  StageTimer timer(on_begin);
  for (const StageTime& entry : proposals.timings) timer.add(entry.stage, entry.seconds);
  SegmentationResult result =
      timer.time("choice", [&] { return choose_objects(proposals, options); });
  timer.time("completion", [&] { complete_objects(proposals.field, options, result); });
  result.timings = timer.stages();
  return result;
}

}  // namespace symscene
