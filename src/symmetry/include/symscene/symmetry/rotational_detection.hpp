#pragma once

#include <optional>
#include <vector>

#include "symscene/core/scene.hpp"
#include "symscene/symmetry/axis_fit.hpp"
#include "symscene/symmetry/point_scores.hpp"

namespace symscene {

/// How well an axis explains a set of points (section 3.5.2).
struct RotationalScores {
  double symmetry_residual = 0.0;   ///< mean ramp of the angle of Fig. 3.4 (Eq. 3.5), in [0, 1]
  double perpendicularity = 0.0;    ///< mean of 1 − angle(normal, axis)/90° (Eq. 3.6), in [0, 1]
  double coverage = 0.0;            ///< share of the full turn that the points span
  double occlusion_residual = 0.0;  ///< mean ramp of distances into free space (Eq. 4.3), in [0, 1]
};

struct RotationalDetectionOptions {
  AxisFitOptions fit;
  double min_angle = radians(10.0);  ///< angles up to here fit perfectly (Eq. 3.5) [rad]
  double max_angle = radians(60.0);  ///< and from here not at all [rad]
  double min_occlusion = 0.01;  ///< distances into free space up to here are noise (Eq. 4.3) [m]
  double max_occlusion = 0.03;  ///< and from here contradict fully [m]
  double max_symmetry_residual = 0.02;  ///< table 4.1
  double max_perpendicularity = 0.6;    ///< table 4.1
  double min_coverage = 0.3;            ///< of a full turn
  double max_occlusion_residual = 0.012;
  double same_angle = radians(10.0);  ///< axes closer than this [rad]
  double same_distance = 0.01;        ///< and this, at their segment, are one [m]

  ScoreRange angle_range() const { return {min_angle, max_angle}; }
  ScoreRange occlusion_range() const { return {min_occlusion, max_occlusion}; }

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("fit", self.fit);
    visit("min_angle", self.min_angle, "rad",
          "angles between normal and axis plane up to here fit perfectly");
    visit("max_angle", self.max_angle, "rad", "and from here not at all");
    visit("min_occlusion", self.min_occlusion, "m",
          "distances into free space up to here are noise");
    visit("max_occlusion", self.max_occlusion, "m", "and from here contradict the axis fully");
    visit("max_symmetry_residual", self.max_symmetry_residual, "",
          "greatest mean angle score of an axis");
    visit("max_perpendicularity", self.max_perpendicularity, "",
          "greatest mean score of normals along the axis");
    visit("min_coverage", self.min_coverage, "turn", "least share of the full turn that is seen");
    visit("max_occlusion_residual", self.max_occlusion_residual, "",
          "greatest mean occlusion score");
    visit("same_angle", self.same_angle, "rad", "axes closer than this and same_distance are one");
    visit("same_distance", self.same_distance, "m", "axes closer than this and same_angle are one");
  }
  /// Throws InputError on a range that is empty or a bound outside its values.
  void validate() const;
};

/// An axis with the segment that proposed it.
struct RotationalCandidate {
  RotationAxis axis;
  RotationalScores scores;
  PointIndices support;  ///< into the cloud, ascending
};

struct RotationalDetection {
  std::vector<RotationalCandidate> candidates;  ///< distinct, best supported first
  std::vector<FunnelStep> funnel;
};

/// The scores of `axis` on the points of `cloud`, which has normals.
RotationalScores rotational_scores(const PointCloud& cloud, const RotationAxis& axis,
                                   const DistanceField& field,
                                   const RotationalDetectionOptions& options);

/// The share of the full turn about `axis` that the points span: 1 − largest gap / 2π.
double angular_coverage(const Points& points, const RotationAxis& axis);

/// The points of a segment that are not on its rim, where normals are worst: those whose neighbours
/// (of the whole cloud, fixed radius) that belong to the segment lie all around them.
PointIndices interior_points(const PointCloud& cloud, const PointIndices& segment, float radius);

/// The rotation axes that the smooth segments of a scene propose (section 3.5.2): every segment is
/// fitted from several initial axes, the accepted fit of lowest occlusion stays, and nearly equal
/// axes are merged. `up` (unit) is the table's normal where known: most things stand. `cloud` has
/// unit normals. Equal for any number of threads.
RotationalDetection detect_rotational(const PointCloud& cloud,
                                      const std::vector<PointIndices>& segments,
                                      const DistanceField& field,
                                      const std::optional<Eigen::Vector3d>& up,
                                      const RotationalDetectionOptions& options = {});

}  // namespace symscene
