#pragma once

#include <numbers>
#include <optional>
#include <vector>

#include "symscene/core/scene.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/symmetry/plane_fit_options.hpp"

namespace symscene {

/// How well a set of points is symmetric about a plane (section 3.5.3). `symmetry_score` and
/// `inlier_score` are scores: 1 is perfect. `occlusion_residual` is a residual: 0 is perfect.
struct PlaneQuality {
  double symmetry_score = 0.0;  ///< mean agreement of normals over correspondences (Eq. 3.9)
  double inlier_score = 0.0;    ///< sum of agreements divided by the number of points (Eq. 3.10)
  double occlusion_residual = 0.0;  ///< mean ramp of distances into free space (Eq. 4.7), in [0, 1]
};

/// How planes are placed before they are fitted (section 3.5.3).
struct PlanePlacementOptions {
  int azimuth_steps = 5;
  int max_points = 200;
  double shift_radius = 0.01;
  double shift_angle = radians(10.0);

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("azimuth_steps", self.azimuth_steps, "", between(1.0, 90.0),
          "orientations: a half turn in this many steps in both spherical angles (section 3.5.3)");
    visit("max_points", self.max_points, "points", at_least(2),
          "points of a segment whose pairs vote for the offset of a plane (Eq. 3.8)");
    visit("shift_radius", self.shift_radius, "m", above(0.0),
          "greatest distance across the normal between two points that vote (Eq. 3.8)");
    visit("shift_angle", self.shift_angle, "rad", strictly_between(0.0, std::numbers::pi),
          "greatest angle between one's reflected normal and the other's normal (Eq. 3.8)");
  }
  void validate() const { check_fields(*this); }
};

/// How the many placed planes of a segment are fitted: a few rounds each on few points, then only
/// the distinct ones to the end.
struct PlaneSearchOptions {
  int coarse_points = 200;
  int coarse_iterations = 4;
  double coarse_same_angle = radians(2.0);
  double coarse_same_distance = 0.003;
  double fine_same_angle = radians(1.0);
  double fine_same_distance = 0.002;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("coarse_points", self.coarse_points, "points", at_least(8),
          "larger segments are subsampled evenly for the first rounds of fitting");
    visit("coarse_iterations", self.coarse_iterations, "", at_least(1),
          "rounds of fitting after which nearly equal planes are dropped");
    visit("coarse_same_angle", self.coarse_same_angle, "rad", at_least(0.0),
          "planes closer than this and coarse_same_distance after these rounds are one");
    visit("coarse_same_distance", self.coarse_same_distance, "m", at_least(0.0),
          "planes closer than this and coarse_same_angle after these rounds are one");
    visit("fine_same_angle", self.fine_same_angle, "rad", at_least(0.0),
          "fitted planes closer than this and fine_same_distance are scored once");
    visit("fine_same_distance", self.fine_same_distance, "m", at_least(0.0),
          "fitted planes closer than this and fine_same_angle are scored once");
  }
  void validate() const { check_fields(*this); }
};

struct ReflectionalDetectionOptions {
  PlanePlacementOptions placement;
  PlaneSearchOptions search;
  PlaneFitOptions fit{.angle_tolerance = radians(0.2), .distance_tolerance = 3e-4};
  CorrespondenceOptions scoring;
  int max_points = 400;
  double min_angle = radians(15.0);
  double max_angle = radians(20.0);
  double min_occlusion = 0.01;
  double max_occlusion = 0.03;
  double min_symmetry_score = 0.8;
  double min_inlier_score = 0.3;
  double max_occlusion_residual = 0.01;
  double same_angle = radians(7.0);
  double same_distance = 0.01;
  double max_support_distance = 0.3;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("placement", self.placement);
    visit("search", self.search);
    visit("fit", self.fit);
    visit("scoring", self.scoring);
    visit("max_points", self.max_points, "points", at_least(8),
          "larger segments are subsampled evenly for fitting and scoring");
    visit("min_angle", self.min_angle, "rad", at_least(0.0),
          "the agreement is 1 at angles between matched normals up to this (Eq. 3.9)");
    visit("max_angle", self.max_angle, "rad", above_up_to(0.0, std::numbers::pi),
          "the agreement is 0 at angles between matched normals from this (Eq. 3.9)");
    visit("min_occlusion", self.min_occlusion, "m", at_least(0.0),
          "the occlusion residual is 0 at distances into free space up to this (Eq. 4.7)");
    visit("max_occlusion", self.max_occlusion, "m", above(0.0),
          "the occlusion residual is 1 at distances into free space from this (Eq. 4.7)");
    visit("min_symmetry_score", self.min_symmetry_score, "", between(0.0, 1.0),
          "lower bound of the mean agreement of matched normals (Eq. 3.9, table 4.1)");
    visit("min_inlier_score", self.min_inlier_score, "", between(0.0, 1.0),
          "lower bound of the agreement summed over all points (Eq. 3.10, table 4.1)");
    visit("max_occlusion_residual", self.max_occlusion_residual, "", between(0.0, 1.0),
          "upper bound of the mean occlusion residual (Eq. 4.7)");
    visit("same_angle", self.same_angle, "rad", at_least(0.0),
          "planes closer than this and same_distance are one (Eq. 3.11)");
    visit("same_distance", self.same_distance, "m", at_least(0.0),
          "planes closer than this, at their segment, and same_angle are one (Eq. 3.12)");
    visit("max_support_distance", self.max_support_distance, "m", at_least(0.0),
          "equal planes of segments whose centroids are farther apart are two: objects in a row");
  }
  /// Throws InputError if a field is out of its range or a score range is empty.
  void validate() const;
};

/// A plane and the segment that proposed it.
struct ReflectionalCandidate {
  ReflectionPlane plane;
  PlaneQuality quality;
  PointIndices support;  ///< into the cloud, ascending
};

struct ReflectionalDetection {
  std::vector<ReflectionalCandidate> candidates;  ///< distinct, lowest occlusion first
  std::vector<FunnelStep> funnel;
};

/// The reflection planes that the smooth segments of a scene propose (section 3.5.3): orientations
/// are sampled about each segment's principal axes (and, where `up` is known, upright ones), placed
/// by votes of pairs of points (Eq. 3.8), fitted (Eq. 3.7), filtered and merged. `cloud` has unit
/// normals, `segments` holds indices into it, `field` is in the same frame, `up` is the table's
/// unit normal. The result does not depend on the number of threads. Throws InputError on invalid
/// options.
ReflectionalDetection detect_reflectional(const PointCloud& cloud,
                                          const std::vector<PointIndices>& segments,
                                          const DistanceField& field,
                                          const std::optional<Eigen::Vector3d>& up,
                                          const ReflectionalDetectionOptions& options = {});

}  // namespace symscene
