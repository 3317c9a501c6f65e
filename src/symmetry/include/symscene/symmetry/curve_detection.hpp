#pragma once

#include "symscene/symmetry/edge_curves.hpp"
#include "symscene/symmetry/reflectional_detection.hpp"

namespace symscene {

/// When two points of curves reflect onto each other, and two curves (section 3.4.2).
struct CurveMatchingOptions {
  double max_angle = radians(10.0);
  double min_distance = 0.02;
  double max_distance = 0.4;
  double angle_bandwidth = radians(5.0);
  double offset_bandwidth = 0.008;
  int max_starts = 400;
  int min_correspondences = 4;
  double min_inlier_ratio = 0.2;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("max_angle", self.max_angle, "rad", between(0.0, std::numbers::pi / 2.0),
          "greatest angle between a tangent and the other's reflected one, M_S (Eq. 3.3; table "
          "4.1: 7°)");
    visit("min_distance", self.min_distance, "m", above(0.0),
          "least distance between two points that reflect onto each other");
    visit("max_distance", self.max_distance, "m", above(0.0),
          "greatest distance between them: the size of the largest object");
    visit("angle_bandwidth", self.angle_bandwidth, "rad", above(0.0),
          "bandwidth of mean shift in the angle between planes (section 3.4.2)");
    visit("offset_bandwidth", self.offset_bandwidth, "m", above(0.0),
          "bandwidth of mean shift in the distance between planes at the centroid of both curves "
          "(section 3.4.2)");
    visit("max_starts", self.max_starts, "", at_least(1.0),
          "greatest number of planes of a pair of curves that are tried as starts of mean shift, "
          "evenly spread");
    visit("min_correspondences", self.min_correspondences, "", at_least(1.0),
          "least number of one-to-one correspondences of a pair of curves");
    visit("min_inlier_ratio", self.min_inlier_ratio, "", between(0.0, 0.5),
          "least number of one-to-one correspondences divided by the number of points of both "
          "curves, n_inlier (section 3.4.2; table 4.1: 0.3)");
  }
  /// Throws InputError if a field is out of its range or max_distance is not above min_distance.
  void validate() const;
};

/// The search for reflection planes by pairs of curves.
struct CurveDetectionOptions {
  CurveMatchingOptions matching;
  double support_radius = 0.015;
  double min_occlusion = 0.01;
  double max_occlusion = 0.03;
  double max_occlusion_residual = 0.05;
  double same_angle = radians(7.0);
  double same_distance = 0.01;
  double max_support_distance = 0.3;
  int max_candidates = 100;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("matching", self.matching);
    visit(
        "support_radius", self.support_radius, "m", above(0.0),
        "the surface within this distance of the matched parts of two curves supports their plane");
    visit("min_occlusion", self.min_occlusion, "m", at_least(0.0),
          "the occlusion residual is 0 at distances into free space up to this (Eq. 4.7)");
    visit("max_occlusion", self.max_occlusion, "m", above(0.0),
          "the occlusion residual is 1 at distances into free space from this (Eq. 4.7)");
    visit("max_occlusion_residual", self.max_occlusion_residual, "", between(0.0, 1.0),
          "upper bound of the mean occlusion residual of that surface; 1 leaves the bound out, as "
          "the "
          "thesis");
    visit("same_angle", self.same_angle, "rad", at_least(0.0),
          "planes closer than this and same_distance are one (Eq. 3.11)");
    visit("same_distance", self.same_distance, "m", at_least(0.0),
          "planes closer than this, at their curves, and same_angle are one (Eq. 3.12)");
    visit("max_support_distance", self.max_support_distance, "m", at_least(0.0),
          "equal planes of curves whose centroids are farther apart are two: objects in a row");
    visit("max_candidates", self.max_candidates, "", at_least(1.0),
          "greatest number of planes, those of the highest inlier ratio; a room has more, and each "
          "costs a graph cut");
  }
  /// Throws InputError if a field is out of its range or a score range is empty.
  void validate() const;
};

/// The reflection planes that pairs of curves propose (section 3.4.2), a curve with itself
/// included: points are matched by their tangents, mean shift finds the dominant plane of each
/// pair, and planes that reflect the curves into free space are dropped. `curves` come from
/// `cloud`, `field` is in the same frame. Candidates are distinct, the highest inlier ratio first;
/// the support of each is the surface beside the matched parts of its curves, its symmetry score
/// the mean agreement of tangents (1 − M_S / max_angle), its inlier score the inlier ratio (at most
/// 0.5). The result does not depend on the number of threads. Throws InputError on invalid options.
ReflectionalDetection detect_reflectional_by_curves(const PointCloud& cloud,
                                                    const std::vector<EdgeCurve>& curves,
                                                    const DistanceField& field,
                                                    const CurveDetectionOptions& options = {});

/// The candidates of curves whose planes repeat none of `known`.
std::vector<ReflectionalCandidate> further_candidates(
    std::vector<ReflectionalCandidate> of_curves, const std::vector<ReflectionalCandidate>& known,
    const PointCloud& cloud, const CurveDetectionOptions& options = {});

}  // namespace symscene
