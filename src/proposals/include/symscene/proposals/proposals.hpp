#pragma once

#include "symscene/classes/classification.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/core/tree_model.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/proposals/object_features.hpp"
#include "symscene/proposals/proposal_options.hpp"
#include "symscene/segmentation/class_segmentation_options.hpp"
#include "symscene/segmentation/hypothesis.hpp"
#include "symscene/segmentation/surface_parts.hpp"
#include "symscene/symmetry/observed_scene.hpp"
#include "symscene/symmetry/reflectional_detection.hpp"
#include "symscene/symmetry/rotational_detection.hpp"

namespace symscene {

/// Hypotheses of the same object, merged (section 4.4).
struct MergedHypothesis {
  PointIndices points;  ///< of the most confident hypothesis, ascending
  /// Distinct ones of all, by ascending HypothesisResiduals::symmetry.
  std::vector<ObjectAxis> axes = {};
  std::vector<ObjectPlane> planes = {};
  double confidence = 0.0;  ///< of the most confident hypothesis (section 4.3.3); 0 for none
};

/// A candidate object with its features and its scores, each in [0, 1].
struct ObjectProposal {
  MergedHypothesis merged;
  ObjectFeatures features;
  double own_score = 0.0;        ///< from its OwnFeatures
  double estimate = 0.0;         ///< from all its features
  double score = 0.0;            ///< `estimate` pooled with that from its relations to others
  ProposalContext context = {};  ///< its relations to others
};

/// The proposals of a scene with the detections and hypotheses that they are made of, before
/// objects are chosen.
struct SceneProposals {
  PointCloud cloud;            ///< the cloud that all indices refer to
  std::optional<Plane> table;  ///< of the scene, where it is known
  DistanceField field;
  std::vector<RotationalCandidate> axes;      ///< detections of the rotational stream
  std::vector<ReflectionalCandidate> planes;  ///< detections of the reflectional stream
  std::vector<Hypothesis> rotational;         ///< of the rotational stream
  std::vector<Hypothesis> reflectional;       ///< of the reflectional stream, with their support
  std::vector<Rejection> rejected;            ///< hypotheses that lost their support
  std::vector<ObjectProposal> objects;        ///< by falling score
  std::vector<FunnelStep> funnel;
  std::vector<StageTime> timings;
  std::vector<std::string> warnings;  ///< the scene's and those of the pipeline, one sentence each

  ObservedScene observed() const { return {cloud, field, table}; }
};

/// Options of the stages that turn hypotheses and parts of the surface into proposals.
struct ProposalOptions {
  SurfacePartsOptions surface_parts;
  HypothesisBounds rotational_bounds;
  HypothesisBounds reflectional_bounds;
  RotationalDetectionOptions rotational_detection;
  ReflectionalDetectionOptions reflectional_detection;
  ContinuationOptions continuation;
  MergeOptions merge;
  ObjectFeatureOptions object_features;
  ProposalContextOptions proposal_context;
  ModelChoice object_alone;
  ModelChoice object_among_others;
  ClassOptions classes;
  ClassSegmentationOptions class_segmentation;
  double spacing = 0.005;  ///< of the cloud [m]
};

}  // namespace symscene
