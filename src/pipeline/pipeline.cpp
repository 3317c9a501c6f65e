#include "symscene/pipeline/pipeline.hpp"

#include "proposals/object_proposals.hpp"
#include "removal.hpp"
#include "workspace.hpp"

namespace symscene {
namespace {

void append(const std::vector<FunnelStep>& steps, std::vector<FunnelStep>& funnel) {
  funnel.insert(funnel.end(), steps.begin(), steps.end());
}

SceneProposals begin_proposals(const Scene& scene, const Workspace& space) {
  SceneProposals proposals;
  proposals.table = scene.table;
  proposals.funnel = {{"points", scene.cloud.size()},
                      {"points at the working spacing", space.cloud.size()},
                      {"smooth segments", space.segments.size()}};
  return proposals;
}

/// Adds what the reflectional stream found in the remainder, with indices into the whole cloud.
void add_reflectional(const Remainder& rest, ReflectionalDetection detection, HypothesisSet set,
                      SceneProposals& proposals) {
  append(detection.funnel, proposals.funnel);
  proposals.planes = std::move(detection.candidates);
  proposals.reflectional = std::move(set.hypotheses);
  proposals.rejected = std::move(set.rejected);
  for (auto& candidate : proposals.planes) candidate.support = rest.in_whole(candidate.support);
  for (auto& hypothesis : proposals.reflectional)
    hypothesis.points = rest.in_whole(hypothesis.points);
  for (auto& rejection : proposals.rejected) rejection.points = rest.in_whole(rejection.points);
}

void end_proposals(Workspace space, const StageTimer& timer, SceneProposals& proposals) {
  proposals.funnel.push_back({"distinct proposals", proposals.objects.size()});
  proposals.cloud = std::move(space.cloud);
  proposals.field = std::move(space.field);
  proposals.warnings = std::move(space.warnings);
  proposals.timings = timer.stages();
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
  SceneProposals proposals = begin_proposals(scene, space);
  if (options.rotational_stream) {
    RotationalDetection axes = timer.time("rotational detection", [&] {  // section 3.5.2
      return detect_rotational(space.cloud, space.segments, space.field, space.up,
                               options.rotational_detection);
    });
    append(axes.funnel, proposals.funnel);
    proposals.axes = std::move(axes.candidates);
    proposals.rotational = timer.time("rotational segmentation", [&] {  // section 4.3.1.1
      return segment_rotational(space.surface(), proposals.axes, options.rotational_detection,
                                options.rotational_segmentation);
    });
  }
  const Remainder rest = timer.time("removal of rotational objects", [&] {  // section 4.4
    return without_rotational_objects(space, proposals.rotational, options);
  });
  ReflectionalDetection planes = timer.time("reflectional detection", [&] {  // section 3.5.3
    return detect_reflectional(rest.cloud, rest.segments, space.field, space.up,
                               options.reflectional_detection);
  });
  HypothesisSet mirrored = timer.time("reflectional segmentation", [&] {  // section 4.3.1.2
    return segment_reflectional({rest.cloud, rest.edges, space.field}, planes.candidates,
                                options.reflectional_detection.fit,
                                options.reflectional_segmentation);
  });
  add_reflectional(rest, std::move(planes), std::move(mirrored), proposals);
  proposals.objects = timer.time("proposals", [&] {  // sections 4.3.3 and 4.4
    return object_proposals(space, proposals, options.proposal_options());
  });
  end_proposals(std::move(space), timer, proposals);
  return proposals;
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
