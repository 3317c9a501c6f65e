#pragma once

#include "symscene/pipeline/pipeline.hpp"
#include "symscene/segmentation/object_measures.hpp"

namespace symscene {

/// A set of points that may be an object, with the symmetries under which it was cut out, if any.
struct ObjectProposal {
  SceneObject object;  ///< its score is the probability of being one whole object
  ObjectMeasures measures;
};

/// What a scene proposes as objects before anything is decided: every segment that was cut out,
/// with its scores. Computed once, thresholds can be swept over it.
struct SceneProposals {
  PointCloud cloud;            ///< the 5 mm cloud that all indices count in
  std::optional<Plane> table;  ///< of the scene, where it is known
  DistanceField field;
  std::vector<RotationalCandidate> axes;      ///< what the rotational stream detected
  std::vector<ReflectionalCandidate> planes;  ///< what the reflectional stream detected
  std::vector<Hypothesis> rotational;         ///< a cut each
  std::vector<Hypothesis> reflectional;       ///< a cut each that holds its support
  std::vector<Rejection> rejected;            ///< cuts that do not
  std::vector<ObjectProposal> objects;        ///< distinct cuts and parts, by falling score
  std::vector<FunnelStep> funnel;
  std::vector<StageTime> timings;
};

/// The cuts of both streams of section 4.4 without the bounds of section 4.3.3, and the parts of
/// the surface, measured and scored. The bounds and the removal score of `options` still decide
/// which rotational objects hide their points from the reflectional stream. Throws InputError as
/// segment_scene() does.
SceneProposals propose_objects(const Scene& scene, const PipelineOptions& options = {},
                               const StageTimer::OnBegin& on_begin = {});

/// The objects that are chosen by probability (select_probable()), with the symmetries under which
/// they were cut out. What is not is added to `rejected`.
std::vector<SceneObject> probable_objects(const SceneProposals& proposals,
                                          const SelectionOptions& options,
                                          std::vector<Rejection>& rejected);

/// Chooses objects among what is proposed, without their completed shapes. With
/// `selection.by_score` by probability among all proposals (select_probable()), and the symmetries
/// of what is chosen are found anew on all its points; otherwise as section 4.3.3 does, among the
/// cuts within the bounds of both streams, equal ones joined (select_consistent()).
SegmentationResult choose_objects(const SceneProposals& proposals,
                                  const PipelineOptions& options = {});

}  // namespace symscene
