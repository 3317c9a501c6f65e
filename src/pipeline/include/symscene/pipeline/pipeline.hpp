#pragma once

#include "symscene/completion/completion.hpp"
#include "symscene/core/normal_estimation.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/pipeline/model_options.hpp"
#include "symscene/proposals/proposals.hpp"
#include "symscene/proposals/selection_options.hpp"
#include "symscene/segmentation/oversegmentation.hpp"
#include "symscene/segmentation/reflectional_segmentation.hpp"
#include "symscene/segmentation/rotational_segmentation.hpp"
#include "symscene/segmentation/surface_graph.hpp"
#include "symscene/symmetry/object_symmetry_options.hpp"

namespace symscene {

/// Every option of every stage.
struct PipelineOptions {
  double voxel_size = 0.005;  ///< spacing of the cloud that everything works on (section 2.1.1) [m]
  double stray_radius = 0.02;  ///< a point with fewer than 3 others so near is a flying pixel [m]
  double space_margin = 0.15;  ///< of known space around the cloud [m]
  double min_removal_score =
      0.6;  ///< a less certain rotational object leaves its points to the planes
  bool rotational_stream = true;  ///< without it planes alone find the objects (section 4.5)
  NormalEstimationOptions normals;
  DistanceFieldOptions distance_field;
  OversegmentationOptions oversegmentation;
  SurfaceGraphOptions surface_graph;
  SurfacePartsOptions surface_parts;
  RotationalDetectionOptions rotational_detection;
  RotationalSegmentationOptions rotational_segmentation;
  ReflectionalDetectionOptions reflectional_detection;
  ReflectionalSegmentationOptions reflectional_segmentation;
  ContinuationOptions continuation;
  MergeOptions merge;
  ObjectFeatureOptions object_features;
  ProposalContextOptions proposal_context;
  ObjectScoreOptions object_score;
  SelectionOptions selection;
  ObjectSymmetryOptions object_symmetry;
  CompletionOptions completion;
  ModelOptions models;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("voxel_size", self.voxel_size, "m", "spacing of the cloud that everything works on");
    visit("stray_radius", self.stray_radius, "m",
          "a point with fewer than 3 others so near is left out");
    visit("space_margin", self.space_margin, "m", "known space that is looked at around the cloud");
    visit("min_removal_score", self.min_removal_score, "",
          "a rotational object of a lower score leaves its points to the reflectional stream too");
    visit("rotational_stream", self.rotational_stream, "",
          "look for rotational objects first; without it planes alone find the objects");
    visit("normals", self.normals);
    visit("distance_field", self.distance_field);
    visit("oversegmentation", self.oversegmentation);
    visit("surface_graph", self.surface_graph);
    visit("surface_parts", self.surface_parts);
    visit("rotational_detection", self.rotational_detection);
    visit("rotational_segmentation", self.rotational_segmentation);
    visit("reflectional_detection", self.reflectional_detection);
    visit("reflectional_segmentation", self.reflectional_segmentation);
    visit("continuation", self.continuation);
    visit("merge", self.merge);
    visit("object_features", self.object_features);
    visit("proposal_context", self.proposal_context);
    visit("object_score", self.object_score);
    visit("selection", self.selection);
    visit("object_symmetry", self.object_symmetry);
    visit("completion", self.completion);
    visit("models", self.models);
  }
  /// Throws InputError if a field of any stage is out of its range.
  void validate() const;

  ProposalOptions proposal_options() const;
  SymmetrySearchOptions symmetry_search_options() const;
};

/// The cuts of both streams of section 4.4 without the bounds of section 4.3.3, and the parts of
/// the surface, measured and scored. The bounds and the removal score of `options` still decide
/// which rotational objects hide their points from the reflectional stream. Throws InputError as
/// segment_scene() does.
SceneProposals propose_objects(const Scene& scene, const PipelineOptions& options = {},
                               const StageTimer::OnBegin& on_begin = {});

/// Chooses objects among what is proposed, without their completed shapes. With
/// `selection.by_score` by probability among all proposals (select_probable()), and the symmetries
/// of what is chosen are found anew on all its points; otherwise as section 4.3.3 does, among the
/// cuts within the bounds of both streams, equal ones joined (select_consistent()).
SegmentationResult choose_objects(const SceneProposals& proposals,
                                  const PipelineOptions& options = {});

/// The objects of a scene (section 4.4): rotational symmetries and their objects first, then
/// reflectional ones among the points that are left; equal objects become one with all their
/// symmetries. `on_begin` hears of every stage. The same bits for any number of threads, but for
/// the times. Throws InputError if the cloud has no finite point, spans more space than memory
/// holds, or an option is invalid.
SegmentationResult segment_scene(const Scene& scene, const PipelineOptions& options = {},
                                 const StageTimer::OnBegin& on_begin = {});

}  // namespace symscene
