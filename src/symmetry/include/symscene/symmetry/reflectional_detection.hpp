#pragma once

#include <optional>
#include <vector>

#include "symscene/core/scene.hpp"
#include "symscene/symmetry/plane_fit.hpp"

namespace symscene {

/// How well a plane explains a set of points (section 3.5.3).
struct ReflectionalScores {
  double symmetry_score = 0.0;  ///< mean agreement of normals over correspondences (Eq. 3.9)
  double inlier_score = 0.0;    ///< agreement summed over all points, by their number (Eq. 3.10)
  double occlusion_residual = 0.0;  ///< mean ramp of distances into free space (Eq. 4.7), in [0, 1]
};

struct ReflectionalDetectionOptions {
  PlaneFitOptions fit;
  CorrespondenceOptions scoring;
  int azimuth_steps = 5;  ///< orientations: steps of 180°/5 = 36° in both angles (section 3.5.3)
  int max_points = 400;   ///< larger segments are thinned evenly for fitting and scoring
  double shift_radius =
      0.01;  ///< reach of the cylinder in which a point seeks partners for Eq. 3.8 [m]
  double shift_angle = radians(10.0);  ///< normals of such partners [rad]
  double min_angle = radians(15.0);    ///< angles up to here fit perfectly (Eq. 3.9) [rad]
  double max_angle = radians(20.0);    ///< and from here not at all [rad]
  double min_occlusion = 0.01;  ///< distances into free space up to here are noise (Eq. 4.7) [m]
  double max_occlusion = 0.03;  ///< and from here contradict fully [m]
  double min_symmetry_score = 0.8;  ///< table 4.1 as used
  double min_inlier_score = 0.3;    ///< table 4.1 as used
  double max_occlusion_residual = 0.01;
  double same_angle = radians(7.0);  ///< planes closer than this [rad]
  double same_distance = 0.01;       ///< and this, at their segment, are one [m]

  ScoreRange angle_range() const { return {min_angle, max_angle}; }
  ScoreRange occlusion_range() const { return {min_occlusion, max_occlusion}; }

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("fit", self.fit);
    visit("scoring", self.scoring);
    visit("azimuth_steps", self.azimuth_steps, "",
          "orientations tried: a half turn in so many steps, both ways");
    visit("max_points", self.max_points, "points", "larger segments are thinned evenly");
    visit("shift_radius", self.shift_radius, "m",
          "reach across the normal when a plane is first placed");
    visit("shift_angle", self.shift_angle, "rad", "angle of normals when a plane is first placed");
    visit("min_angle", self.min_angle, "rad",
          "angles between matched normals up to here fit perfectly");
    visit("max_angle", self.max_angle, "rad", "and from here not at all");
    visit("min_occlusion", self.min_occlusion, "m",
          "distances into free space up to here are noise");
    visit("max_occlusion", self.max_occlusion, "m", "and from here contradict the plane fully");
    visit("min_symmetry_score", self.min_symmetry_score, "",
          "least mean agreement of matched normals");
    visit("min_inlier_score", self.min_inlier_score, "", "least agreement summed over all points");
    visit("max_occlusion_residual", self.max_occlusion_residual, "",
          "greatest mean occlusion score");
    visit("same_angle", self.same_angle, "rad",
          "planes closer than this and same_distance are one");
    visit("same_distance", self.same_distance, "m",
          "planes closer than this and same_angle are one");
  }
  /// Throws InputError on a range that is empty or a bound outside its values.
  void validate() const;
};

/// A plane with the segment that proposed it.
struct ReflectionalCandidate {
  ReflectionPlane plane;
  ReflectionalScores scores;
  PointIndices support;  ///< into the cloud, ascending
};

struct ReflectionalDetection {
  std::vector<ReflectionalCandidate> candidates;  ///< distinct, lowest occlusion first
  std::vector<FunnelStep> funnel;
};

/// The scores of `plane` on the points `members` of `cloud`, matched among the points that `cells`
/// holds.
ReflectionalScores reflectional_scores(const PointCloud& cloud, const CellList& cells,
                                       std::span<const Index> members, const ReflectionPlane& plane,
                                       const DistanceField& field,
                                       const ReflectionalDetectionOptions& options);

/// The reflection planes that the smooth segments of a scene propose (section 3.5.3): orientations
/// sampled about each segment's principal axes (and, where `up` is known, upright ones), placed by
/// the votes of pairs of points, fitted, filtered and merged. `cloud` has unit normals. Equal for
/// any number of threads.
ReflectionalDetection detect_reflectional(const PointCloud& cloud,
                                          const std::vector<PointIndices>& segments,
                                          const DistanceField& field,
                                          const std::optional<Eigen::Vector3d>& up,
                                          const ReflectionalDetectionOptions& options = {});

}  // namespace symscene
