#include "symscene/pipeline/pipeline.hpp"

#include "proposals/object_proposals.hpp"
#include "symscene/core/error.hpp"
#include "workspace.hpp"

namespace symscene {
namespace {

void rotational_stream(const Workspace& space, const PipelineOptions& options, StageTimer& timer,
                       SceneProposals& proposals) {
  RotationalDetection detection = timer.time("rotational detection", [&] {
    return detect_rotational(space.cloud, space.segments, space.field, space.up,
                             options.rotational_detection);
  });
  proposals.funnel.insert(proposals.funnel.end(), detection.funnel.begin(), detection.funnel.end());
  proposals.axes = std::move(detection.candidates);
  proposals.rotational = timer.time("rotational segmentation", [&] {
    return segment_rotational(space.cloud, space.edges, proposals.axes, space.field,
                              options.rotational_detection, options.rotational_segmentation);
  });
}

void reflectional_stream(const Remainder& rest, const DistanceField& field,
                         const PipelineOptions& options, StageTimer& timer,
                         SceneProposals& proposals) {
  const Workspace& space = rest.space;
  const auto to_whole = [&](PointIndices& points) {
    for (Index& i : points) i = rest.original[i];
  };
  ReflectionalDetection detection = timer.time("reflectional detection", [&] {
    return detect_reflectional(space.cloud, space.segments, field, space.up,
                               options.reflectional_detection);
  });
  proposals.funnel.insert(proposals.funnel.end(), detection.funnel.begin(), detection.funnel.end());
  HypothesisSet set = timer.time("reflectional segmentation", [&] {
    return segment_reflectional(space.cloud, space.edges, detection.candidates, field,
                                options.reflectional_detection.fit,
                                options.reflectional_segmentation);
  });
  proposals.planes = std::move(detection.candidates);
  for (ReflectionalCandidate& candidate : proposals.planes) to_whole(candidate.support);
  proposals.reflectional = std::move(set.hypotheses);
  for (Hypothesis& hypothesis : proposals.reflectional) to_whole(hypothesis.points);
  proposals.rejected = std::move(set.rejected);
  for (Rejection& rejection : proposals.rejected) to_whole(rejection.points);
}

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

void PipelineOptions::validate() const {
  require_option(voxel_size >= 1e-4 && voxel_size <= 1.0, "voxel_size",
                 "a length from 0.0001 to 1 m", voxel_size);
  require_option(stray_radius > 0.0 && stray_radius <= 1.0, "stray_radius", "a length in (0, 1] m",
                 stray_radius);
  require_option(space_margin >= 0.0 && space_margin <= 10.0, "space_margin",
                 "a length from 0 to 10 m", space_margin);
  require_option(min_removal_score >= 0.0 && min_removal_score <= 1.0, "min_removal_score",
                 "a score in [0, 1]", min_removal_score);
  normals.validate();
  distance_field.validate();
  oversegmentation.validate();
  surface_graph.validate();
  surface_parts.validate();
  rotational_detection.validate();
  rotational_segmentation.validate();
  reflectional_detection.validate();
  reflectional_segmentation.validate();
  continuation.validate();
  merge.validate();
  object_features.validate();
  proposal_context.validate();
  object_score.validate();
  selection.validate();
  object_symmetry.validate();
  completion.validate();
  models.validate();
}

ProposalOptions PipelineOptions::proposal_options() const {
  return {surface_parts,
          rotational_segmentation.bounds,
          reflectional_segmentation.bounds,
          rotational_detection,
          reflectional_detection,
          continuation,
          merge,
          object_features,
          proposal_context,
          object_score,
          models.object_alone,
          models.object_among_others};
}

SymmetrySearchOptions PipelineOptions::symmetry_search_options() const {
  return {rotational_stream, rotational_detection, reflectional_detection,
          object_symmetry,   models.axis,          models.plane};
}

SceneProposals propose_objects(const Scene& scene, const PipelineOptions& options,
                               const StageTimer::OnBegin& on_begin) {
  options.validate();
  StageTimer timer(on_begin);
  SceneProposals proposals;
  proposals.table = scene.table;
  Workspace space = build_workspace(scene, options, timer);
  proposals.funnel = {{"points", scene.cloud.size()},
                      {"points at the working spacing", space.cloud.size()},
                      {"smooth segments", space.segments.size()}};
  if (options.rotational_stream) rotational_stream(space, options, timer, proposals);
  const Remainder rest = timer.time("removal of rotational objects", [&] {
    return without_objects(space, proposals.rotational, options);
  });
  reflectional_stream(rest, space.field, options, timer, proposals);
  proposals.objects = timer.time(
      "proposals", [&] { return object_proposals(space, proposals, options.proposal_options()); });
  proposals.funnel.push_back({"distinct proposals", proposals.objects.size()});
  proposals.cloud = std::move(space.cloud);
  proposals.field = std::move(space.field);
  proposals.timings = timer.stages();
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
