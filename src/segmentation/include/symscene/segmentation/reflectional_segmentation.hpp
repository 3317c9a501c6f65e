#pragma once

#include "symscene/segmentation/hypothesis.hpp"
#include "symscene/symmetry/reflectional_detection.hpp"

namespace symscene {

struct ReflectionalSegmentationOptions {
  CorrespondenceOptions matching;
  double min_angle = radians(10.0);  ///< angles up to here fit perfectly (Eq. 4.6) [rad]
  double max_angle = radians(45.0);  ///< and from here not at all [rad]
  double min_occlusion = 0.01;  ///< distances into free space up to here are noise (Eq. 4.7) [m]
  double max_occlusion = 0.03;  ///< and from here contradict fully [m]
  double loud_angle =
      radians(45.0);  ///< a normal so near to the plane's says all that it can [rad]
  double silent_angle =
      radians(80.0);  ///< and from here nothing, outside the segment that proposed the plane [rad]
  double background_weight = 2.0;  ///< weight of the affinity to the background
  double edge_factor = 5.0;        ///< λ (Eq. 4.1)
  double pair_weight = 1.0;        ///< of the edge between two points that reflect to one another
  double min_support_share = 0.5;  ///< of the proposing segment that the object must hold
  HypothesisBounds bounds{0.3, 0.005, 0.3, 200};

  ScoreRange angle_range() const { return {min_angle, max_angle}; }
  ScoreRange occlusion_range() const { return {min_occlusion, max_occlusion}; }

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("matching", self.matching);
    visit("min_angle", self.min_angle, "rad",
          "angles between matched normals up to here fit perfectly");
    visit("max_angle", self.max_angle, "rad", "and from here not at all");
    visit("min_occlusion", self.min_occlusion, "m",
          "distances into free space up to here are noise");
    visit("max_occlusion", self.max_occlusion, "m", "and from here contradict the plane fully");
    visit("loud_angle", self.loud_angle, "rad", "a normal so near to the plane's is full evidence");
    visit("silent_angle", self.silent_angle, "rad",
          "and from here none, outside the proposing segment");
    visit("background_weight", self.background_weight, "",
          "weight of the affinity to the background");
    visit("edge_factor", self.edge_factor, "", "weight of the edges of the surface graph");
    visit("pair_weight", self.pair_weight, "", "weight of the edge between symmetric points");
    visit("min_support_share", self.min_support_share, "",
          "share of the proposing segment that an object holds");
    visit("bounds", self.bounds);
  }
  /// Throws InputError on a range that is empty or a weight that is negative.
  void validate() const;
};

/// Cuts the points out that agree with each reflection plane (sections 4.3, 4.3.1.2), refits the
/// plane to its cut, cuts once more and scores the outcome (section 4.3.3). `edges` is the surface
/// graph of `cloud`. Equal for any number of threads; hypotheses are in the order of their
/// candidates.
HypothesisSet segment_reflectional(const PointCloud& cloud, const std::vector<WeightedEdge>& edges,
                                   const std::vector<ReflectionalCandidate>& candidates,
                                   const DistanceField& field, const PlaneFitOptions& fit,
                                   const ReflectionalSegmentationOptions& options = {});

}  // namespace symscene
