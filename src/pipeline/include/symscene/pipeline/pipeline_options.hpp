#pragma once

#include "symscene/classes/classification.hpp"
#include "symscene/completion/object_surface.hpp"
#include "symscene/core/normal_estimation.hpp"
#include "symscene/core/options.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/occupancy/outward_vote.hpp"
#include "symscene/pipeline/model_options.hpp"
#include "symscene/proposals/proposals.hpp"
#include "symscene/proposals/selection_options.hpp"
#include "symscene/segmentation/class_segmentation_options.hpp"
#include "symscene/segmentation/oversegmentation.hpp"
#include "symscene/segmentation/reflectional_segmentation.hpp"
#include "symscene/segmentation/rotational_segmentation.hpp"
#include "symscene/segmentation/supervoxels.hpp"
#include "symscene/segmentation/surface_graph.hpp"
#include "symscene/symmetry/curve_detection.hpp"
#include "symscene/symmetry/edge_curves.hpp"
#include "symscene/symmetry/object_symmetry_options.hpp"

namespace symscene {

/// Every option of every stage.
struct PipelineOptions {
  double voxel_size = 0.005;
  double stray_radius = 0.02;
  int stray_neighbors = 3;
  double space_margin = 0.15;
  double frame_tolerance = 0.02;
  double min_removal_confidence = 0.6;
  bool rotational_stream = true;
  bool planes_of_surfaces = true;
  bool planes_of_curves = true;
  bool complete_by_symmetry = true;
  NormalEstimationOptions normals;
  OutwardVoteOptions outward_vote;
  DistanceFieldOptions distance_field;
  OversegmentationOptions oversegmentation;
  SurfaceGraphOptions surface_graph;
  SurfacePartsOptions surface_parts;
  RotationalDetectionOptions rotational_detection;
  RotationalSegmentationOptions rotational_segmentation;
  ReflectionalDetectionOptions reflectional_detection;
  SupervoxelOptions supervoxels;
  EdgeCurveOptions edge_curves;
  CurveDetectionOptions curve_detection;
  ReflectionalSegmentationOptions reflectional_segmentation;
  ClassSegmentationOptions class_segmentation;
  ContinuationOptions continuation;
  MergeOptions merge;
  ObjectFeatureOptions object_features;
  ProposalContextOptions proposal_context;
  SelectionOptions selection;
  ObjectSymmetryOptions object_symmetry;
  ClassOptions classes;
  CompletionOptions completion;
  ObjectSurfaceOptions object_surface;
  ModelOptions models;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("voxel_size", self.voxel_size, "m", between(1e-4, 1.0),
          "spacing of the sampled cloud that all stages work on (section 2.1.1)");
    visit("stray_radius", self.stray_radius, "m", above_up_to(0.0, 1.0),
          "radius in which a point needs stray_neighbors others (section 2.1.1)");
    visit("stray_neighbors", self.stray_neighbors, "points", at_least(0.0),
          "a point with fewer others within stray_radius is left out as stray (section 2.1.1)");
    visit("space_margin", self.space_margin, "m", between(0.0, 10.0),
          "margin around the cloud within which free space is read (section 2.1.2)");
    visit(
        "frame_tolerance", self.frame_tolerance, "m", at_least(0.0),
        "a warning tells that the cloud may be in another frame if most of its points are farther "
        "below the table or inside free space");
    visit("min_removal_confidence", self.min_removal_confidence, "", between(0.0, 1.0),
          "a rotational hypothesis of lower confidence leaves its points to the reflectional "
          "stream too (section 4.4)");
    visit("rotational_stream", self.rotational_stream, "", any_value(),
          "detect rotational objects first; without this, reflection planes alone find the objects "
          "(section 4.5)");
    visit("planes_of_surfaces", self.planes_of_surfaces, "", any_value(),
          "detect reflection planes by fits to smooth segments (section 3.5.3)");
    visit("planes_of_curves", self.planes_of_curves, "", any_value(),
          "detect reflection planes by pairs of edge curves (section 3.4)");
    visit("complete_by_symmetry", self.complete_by_symmetry, "", any_value(),
          "infer the hidden side of an object from its symmetries (section 1.3); without this, its "
          "closed surface ends at the visible hull of its observed points");
    visit("normals", self.normals);
    visit("outward_vote", self.outward_vote);
    visit("distance_field", self.distance_field);
    visit("oversegmentation", self.oversegmentation);
    visit("surface_graph", self.surface_graph);
    visit("surface_parts", self.surface_parts);
    visit("rotational_detection", self.rotational_detection);
    visit("rotational_segmentation", self.rotational_segmentation);
    visit("reflectional_detection", self.reflectional_detection);
    visit("supervoxels", self.supervoxels);
    visit("edge_curves", self.edge_curves);
    visit("curve_detection", self.curve_detection);
    visit("reflectional_segmentation", self.reflectional_segmentation);
    visit("class_segmentation", self.class_segmentation);
    visit("continuation", self.continuation);
    visit("merge", self.merge);
    visit("object_features", self.object_features);
    visit("proposal_context", self.proposal_context);
    visit("selection", self.selection);
    visit("object_symmetry", self.object_symmetry);
    visit("classes", self.classes);
    visit("completion", self.completion);
    visit("object_surface", self.object_surface);
    visit("models", self.models);
  }
  /// Throws InputError if a field of any stage is out of its range.
  void validate() const { check_fields(*this); }

  ProposalOptions proposal_options() const;
  SymmetrySearchOptions symmetry_search_options() const;
};

}  // namespace symscene
