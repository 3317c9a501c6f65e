#pragma once

#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include "symscene/core/scene.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/symmetry/axis_fit_options.hpp"

namespace symscene {

/// How well a set of points is symmetric about an axis (section 3.5.2). Lower is better, except for
/// `coverage`.
struct AxisQuality {
  double symmetry_residual = 0.0;   ///< mean ramp of the angle of Fig. 3.4 (Eq. 3.5), in [0, 1]
  double perpendicularity = 0.0;    ///< mean of 1 − angle(normal, axis)/90° (Eq. 3.6), in [0, 1]
  double coverage = 0.0;            ///< share of the full turn that the points span
  double occlusion_residual = 0.0;  ///< mean ramp of distances into free space (Eq. 4.3), in [0, 1]
};

/// How the best axis of a segment was judged: no axis was fitted, the first bound that it fails, or
/// none. In the order of judgement, so that a later one is better.
enum class AxisOutcome : std::uint8_t {
  no_fit,
  symmetry,
  perpendicularity,
  coverage,
  occlusion,
  accepted
};
/// The name of the enumerator.
const char* to_string(AxisOutcome outcome);

/// The outcome with the value that was compared and its bound; both are 0 without a fit and for
/// accepted axes.
struct AxisJudgement {
  AxisOutcome outcome = AxisOutcome::no_fit;
  double value = 0.0;
  double bound = 0.0;
};

struct RotationalDetectionOptions {
  AxisFitOptions fit;
  double rim_radius = 0.01;
  double rim_offset = 0.31;
  double min_angle = radians(10.0);
  double max_angle = radians(60.0);
  double min_occlusion = 0.01;
  double max_occlusion = 0.03;
  double max_symmetry_residual = 0.02;
  double max_perpendicularity = 0.6;
  double min_coverage = 0.3;
  double max_occlusion_residual = 0.012;
  double same_angle = radians(10.0);
  double same_distance = 0.01;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("fit", self.fit);
    visit("rim_radius", self.rim_radius, "m", above(0.0),
          "radius of the neighbourhood that identifies rim points of a segment, which are not "
          "fitted");
    visit(
        "rim_offset", self.rim_offset, "", above(0.0),
        "a point is on the rim if the mean of its neighbours is at least this share of rim_radius "
        "away; 0.31 is that of a sector of 225 degrees");
    visit("min_angle", self.min_angle, "rad", at_least(0.0),
          "the symmetry residual is 0 at angles up to this (Eq. 3.5)");
    visit("max_angle", self.max_angle, "rad", above_up_to(0.0, std::numbers::pi / 2),
          "the symmetry residual is 1 at angles from this (Eq. 3.5)");
    visit("min_occlusion", self.min_occlusion, "m", at_least(0.0),
          "the occlusion residual is 0 at distances into free space up to this (Eq. 4.3)");
    visit("max_occlusion", self.max_occlusion, "m", above(0.0),
          "the occlusion residual is 1 at distances into free space from this (Eq. 4.3)");
    visit("max_symmetry_residual", self.max_symmetry_residual, "", between(0.0, 1.0),
          "upper bound of the mean symmetry residual of an axis (Eq. 3.5, table 4.1)");
    visit("max_perpendicularity", self.max_perpendicularity, "", between(0.0, 1.0),
          "upper bound of the mean perpendicularity of an axis (Eq. 3.6, table 4.1)");
    visit("min_coverage", self.min_coverage, "turn", between(0.0, 1.0),
          "lower bound of the share of the full turn that is observed");
    visit("max_occlusion_residual", self.max_occlusion_residual, "", between(0.0, 1.0),
          "upper bound of the mean occlusion residual of an axis (Eq. 4.3)");
    visit("same_angle", self.same_angle, "rad", at_least(0.0),
          "axes closer than this and same_distance are one (Eq. 3.11)");
    visit("same_distance", self.same_distance, "m", at_least(0.0),
          "axes closer than this, at their segment, and same_angle are one (Eq. 3.12)");
  }
  /// Throws InputError if a field is out of its range or a score range is empty.
  void validate() const;
};

/// An axis and the segment that proposed it.
struct RotationalCandidate {
  RotationAxis axis;
  AxisQuality quality;
  PointIndices support;  ///< into the cloud, ascending
};

struct RotationalDetection {
  std::vector<RotationalCandidate> candidates;  ///< distinct, largest support first
  std::vector<FunnelStep> funnel;
};

/// The rotation axes that the smooth segments of a scene propose (section 3.5.2): every segment is
/// fitted from several initial axes, the accepted fit of lowest occlusion stays, and nearly equal
/// axes are merged. `cloud` has unit normals, `segments` holds indices into it, `field` is in the
/// same frame. `up` is the table's unit normal where known; it is one more initial direction.
/// The result does not depend on the number of threads. Throws InputError on invalid options.
RotationalDetection detect_rotational(const PointCloud& cloud,
                                      const std::vector<PointIndices>& segments,
                                      const DistanceField& field,
                                      const std::optional<Eigen::Vector3d>& up,
                                      const RotationalDetectionOptions& options = {});

}  // namespace symscene
