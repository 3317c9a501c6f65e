#include "symscene/pipeline/pipeline.hpp"

#include "proposals/object_proposals.hpp"
#include "removal.hpp"
#include "workspace.hpp"

namespace symscene {
namespace {

void append(const std::vector<FunnelStep>& steps, std::vector<FunnelStep>& funnel) {
  funnel.insert(funnel.end(), steps.begin(), steps.end());
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

/// Turns indices into the remainder into indices into the whole cloud.
void index_whole_cloud(const Remainder& rest, std::vector<ReflectionalCandidate>& candidates,
                       SegmentedHypotheses& segmented) {
  for (auto& candidate : candidates) candidate.support = rest.in_whole(candidate.support);
  for (auto& hypothesis : segmented.hypotheses)
    hypothesis.points = rest.in_whole(hypothesis.points);
  for (auto& rejection : segmented.rejected) rejection.points = rest.in_whole(rejection.points);
}

/// Adds the hidden points of every object and its centre of mass.
void complete_objects(const DistanceField& field, const CompletionOptions& options,
                      SegmentationResult& result) {
  for (SceneObject& object : result.objects) {
    const PointCloud observed = select(result.cloud, object.points);
    PointCloud added =
        complete_object(observed, object.rotational, object.reflectional, field, options);
    object.centroid =
        centre_of_mass({observed, added, object.rotational, object.reflectional}, options);
    result.completed.push_back(std::move(added));
  }
}

}  // namespace

SceneProposals propose_objects(const Scene& scene, const PipelineOptions& options,
                               const StageTimer::OnBegin& on_begin) {
  options.validate();
  StageTimer timer(on_begin);
  Workspace space = build_workspace(scene, options, timer);  // sections 2.1, 3.5.1 and 4.3.2
  RotationalDetection axes;
  std::vector<Hypothesis> rotational;
  if (options.rotational_stream) {
    axes = timer.time("rotational detection", [&] {  // section 3.5.2
      return detect_rotational(space.cloud, space.segments, space.field, space.up,
                               options.rotational_detection);
    });
    rotational = timer.time("rotational segmentation", [&] {  // section 4.3.1.1
      return segment_rotational(space.surface(), axes.candidates, options.rotational_detection,
                                options.rotational_segmentation);
    });
  }
  const Remainder rest = timer.time("removal of rotational objects", [&] {  // section 4.4
    return without_rotational_objects(space, rotational, options);
  });
  ReflectionalDetection planes = timer.time("reflectional detection", [&] {  // section 3.5.3
    return detect_reflectional(rest.cloud, rest.segments, space.field, space.up,
                               options.reflectional_detection);
  });
  SegmentedHypotheses reflectional = timer.time("reflectional segmentation", [&] {  // 4.3.1.2
    return segment_reflectional({rest.cloud, rest.edges, space.field}, planes.candidates,
                                options.reflectional_detection.fit,
                                options.reflectional_segmentation);
  });
  index_whole_cloud(rest, planes.candidates, reflectional);
  std::vector<ObjectProposal> objects = timer.time("proposals", [&] {  // sections 4.3.3 and 4.4
    return object_proposals(space, rotational, reflectional.hypotheses, options.proposal_options());
  });
  std::vector<FunnelStep> funnel = funnel_of(scene, space, axes, planes, objects.size());
  return {.cloud = std::move(space.cloud),
          .table = scene.table,
          .field = std::move(space.field),
          .axes = std::move(axes.candidates),
          .planes = std::move(planes.candidates),
          .rotational = std::move(rotational),
          .reflectional = std::move(reflectional.hypotheses),
          .rejected = std::move(reflectional.rejected),
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
  timer.time("completion", [&] { complete_objects(proposals.field, options.completion, result); });
  result.timings = timer.stages();
  return result;
}

}  // namespace symscene
