#pragma once

#include "symscene/segmentation/hypothesis.hpp"
#include "symscene/symmetry/rotational_detection.hpp"

namespace symscene {

struct RotationalSegmentationOptions {
  double min_angle = radians(0.0);   ///< angles up to here fit perfectly (Eq. 4.2) [rad]
  double max_angle = radians(15.0);  ///< and from here not at all [rad]
  double min_occlusion = 0.005;  ///< distances into free space up to here are noise (Eq. 4.3) [m]
  double max_occlusion = 0.03;   ///< and from here contradict fully [m]
  double silent_angle =
      radians(30.0);  ///< normals nearer to the axis than this say less and less of it [rad]
  double background_weight = 0.5;        ///< weight of the affinity to the background
  double edge_factor = 2.0;              ///< λ (Eq. 4.1)
  double max_refinement = radians(5.0);  ///< an axis refitted to its cut may turn so far [rad]
  double min_component = 0.1;            ///< pieces below this share of the largest are dropped
  HypothesisBounds bounds{0.03, 0.015, 0.3, 100};

  ScoreRange angle_range() const { return {min_angle, max_angle}; }
  ScoreRange occlusion_range() const { return {min_occlusion, max_occlusion}; }

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("min_angle", self.min_angle, "rad",
          "angles between normal and axis plane up to here fit perfectly");
    visit("max_angle", self.max_angle, "rad", "and from here not at all");
    visit("min_occlusion", self.min_occlusion, "m",
          "distances into free space up to here are noise");
    visit("max_occlusion", self.max_occlusion, "m", "and from here contradict the axis fully");
    visit("silent_angle", self.silent_angle, "rad",
          "normals nearer to the axis say less and less of it");
    visit("background_weight", self.background_weight, "",
          "weight of the affinity to the background");
    visit("edge_factor", self.edge_factor, "", "weight of the edges of the surface graph");
    visit("max_refinement", self.max_refinement, "rad",
          "an axis refitted to its cut may turn so far");
    visit("min_component", self.min_component, "",
          "pieces below this share of the largest are dropped");
    visit("bounds", self.bounds);
  }
  /// Throws InputError on a range that is empty or a weight that is negative.
  void validate() const;
};

/// Cuts the points out that agree with each rotation axis (section 4.3, 4.3.1.1), refits the axis
/// to its cut, cuts once more and scores the outcome by the detector's scores. `edges` is the
/// surface graph of `cloud`. Equal for any number of threads; a hypothesis each, in the order of
/// the candidates; some may be empty.
std::vector<Hypothesis> segment_rotational(const PointCloud& cloud,
                                           const std::vector<WeightedEdge>& edges,
                                           const std::vector<RotationalCandidate>& candidates,
                                           const DistanceField& field,
                                           const RotationalDetectionOptions& detection,
                                           const RotationalSegmentationOptions& options = {});

}  // namespace symscene
