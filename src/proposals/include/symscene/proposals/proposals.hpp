#pragma once

#include "symscene/core/scene.hpp"
#include "symscene/core/tree_model.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/proposals/continuation.hpp"
#include "symscene/proposals/merge.hpp"
#include "symscene/proposals/object_features.hpp"
#include "symscene/proposals/selection.hpp"
#include "symscene/segmentation/hypothesis.hpp"
#include "symscene/segmentation/surface_parts.hpp"
#include "symscene/symmetry/object_symmetry_bounds.hpp"
#include "symscene/symmetry/reflectional_detection.hpp"
#include "symscene/symmetry/rotational_detection.hpp"

namespace symscene {

/// A set of points that may be an object, with the symmetries under which it was cut out, if any.
struct ObjectProposal {
  SceneObject object;  ///< its score is the probability of being one whole object
  ObjectFeatures features;
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

  ObservedScene observed() const { return {cloud, field, table}; }
};

/// Options of the stages that make proposals of cuts and of the surface's parts.
struct ProposalOptions {
  SurfacePartsOptions surface_parts;
  HypothesisBounds rotational_bounds;
  HypothesisBounds reflectional_bounds;
  RotationalDetectionOptions rotational_detection;
  ReflectionalDetectionOptions reflectional_detection;
  ContinuationOptions continuation;
  MergeOptions merge;
  ModelChoice object_alone;
  ModelChoice object_among_others;
};

/// The objects that are chosen by probability (select_probable()), with the symmetries under which
/// they were cut out. What is not is added to `rejected`.
std::vector<SceneObject> probable_objects(const SceneProposals& proposals,
                                          const SelectionOptions& options,
                                          std::vector<Rejection>& rejected);

}  // namespace symscene
