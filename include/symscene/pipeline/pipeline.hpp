#pragma once

#include "symscene/completion/completion.hpp"
#include "symscene/core/normal_estimation.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/pipeline/merge.hpp"
#include "symscene/pipeline/selection.hpp"
#include "symscene/segmentation/oversegmentation.hpp"
#include "symscene/segmentation/reflectional_segmentation.hpp"
#include "symscene/segmentation/rotational_segmentation.hpp"
#include "symscene/segmentation/surface_graph.hpp"
#include "symscene/segmentation/surface_parts.hpp"
#include "symscene/symmetry/reflectional_detection.hpp"
#include "symscene/symmetry/rotational_detection.hpp"

namespace symscene {

/// Which proposals are joined because one continues the other behind what hides the space between.
struct ContinuationOptions {
  int most = 40;                   ///< proposals that may continue another, the best ones
  double min_score = 0.1;          ///< least score of proposals that are looked at
  double min_continuation = 0.15;  ///< least share of points of both that continue the other
  double whole_belief = 0.75;      ///< that parts are one, where together they look like an object
  double reach = 0.2;              ///< greatest distance between the two [m]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("most", self.most, "", "so many of the best proposals may continue another");
    visit("min_score", self.min_score, "", "least score of proposals that are looked at");
    visit("min_continuation", self.min_continuation, "",
          "share of points that continue the other, for two to be joined");
    visit("whole_belief", self.whole_belief, "",
          "that what continues one another is one object where it looks like one");
    visit("reach", self.reach, "m", "greatest distance between the two");
  }
  /// Throws InputError on a value below 0.
  void validate() const;
};

/// Which symmetries an object has, once its points are known.
struct ObjectSymmetryBounds {
  double max_axis_misfit = 0.05;            ///< greatest mean angle score (Eq. 3.5)
  double max_axis_occlusion = 0.05;         ///< greatest mean occlusion score (Eq. 4.3)
  double min_axis_coverage = 0.25;          ///< of a full turn
  double min_axis_probability = 0.1;        ///< of an axis (axis_probability())
  double min_plane_matched = 0.05;          ///< least share of points whose image is on the surface
  double max_plane_contradicted = 0.3;      ///< greatest share of the images that can be judged
  double min_plane_probability = 0.4;       ///< of being a mirror (plane_probability())
  double max_image_offset = 0.003;          ///< of an image off the surface that it is on [m]
  double max_image_angle = radians(20.0);   ///< of its normal [rad]
  double same_plane_angle = radians(12.0);  ///< planes closer than this are one [rad]
  double min_plane_distance = 0.003;        ///< points nearer to a plane match themselves [m]
  double plane_in_axis_angle = radians(10.0);  ///< planes that hold an axis so nearly follow [rad]
  double plane_in_axis_distance = 0.01;        ///< and pass it this near [m]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("max_axis_misfit", self.max_axis_misfit, "", "greatest mean angle score of an axis");
    visit("max_axis_occlusion", self.max_axis_occlusion, "", "greatest occlusion of an axis");
    visit("min_axis_coverage", self.min_axis_coverage, "",
          "share of a full turn that is seen about an axis");
    visit("min_axis_probability", self.min_axis_probability, "",
          "least probability of an axis that is listed");
    visit("min_plane_matched", self.min_plane_matched, "",
          "least share of points whose image is on the surface");
    visit("max_plane_contradicted", self.max_plane_contradicted, "",
          "share of images that are in empty space, inside or off the surface");
    visit("min_plane_probability", self.min_plane_probability, "",
          "least probability of a plane that is listed");
    visit("max_image_offset", self.max_image_offset, "m", "of an image that is on the surface");
    visit("max_image_angle", self.max_image_angle, "rad", "of its normal");
    visit("same_plane_angle", self.same_plane_angle, "rad", "planes closer than this are one");
    visit("min_plane_distance", self.min_plane_distance, "m",
          "points nearer to a plane do not count");
    visit("plane_in_axis_angle", self.plane_in_axis_angle, "rad",
          "planes that hold an axis so nearly follow from it");
    visit("plane_in_axis_distance", self.plane_in_axis_distance, "m", "and pass it this near");
  }
  /// Throws InputError on a value below 0, or above 1 where it has no unit.
  void validate() const;
};

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
  SelectionOptions selection;
  ObjectSymmetryBounds object_symmetry;
  CompletionOptions completion;

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
    visit("selection", self.selection);
    visit("object_symmetry", self.object_symmetry);
    visit("completion", self.completion);
  }
  /// Throws InputError if a field of any stage is out of its range.
  void validate() const;
};

/// The objects of a scene (section 4.4): rotational symmetries and their objects first, then
/// reflectional ones among the points that are left; equal objects become one with all their
/// symmetries. `on_begin` hears of every stage. The same bits for any number of threads, but for
/// the times. Throws InputError if the cloud has no finite point, spans more space than memory
/// holds, or an option is invalid.
SegmentationResult segment_scene(const Scene& scene, const PipelineOptions& options = {},
                                 const StageTimer::OnBegin& on_begin = {});

}  // namespace symscene
