#pragma once

#include <optional>
#include <string>
#include <vector>

#include "symscene/core/options.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/segmentation/graph_cut.hpp"

namespace symscene {

/// The surface and the space that hypotheses are cut out of. A view: it owns nothing.
struct ObservedSurface {
  const PointCloud& cloud;                 ///< with unit normals
  const std::vector<WeightedEdge>& edges;  ///< the surface graph of `cloud` (Eq. 4.10)
  const DistanceField& field;
};

/// Residuals of a hypothesis under its symmetry (section 4.3.3). Lower is better.
struct HypothesisResiduals {
  double symmetry = 0.0;    ///< Eq. 4.11, in [0, 1]
  double occlusion = 0.0;   ///< Eq. 4.12, in [0, 1]
  double smoothness = 0.0;  ///< weight of the broken edges per point (Eq. 4.13 as used)
};

/// The bounds that a hypothesis must satisfy to be an object (section 4.3.3).
struct HypothesisBounds {
  double max_symmetry = 0.03;
  double max_occlusion = 0.015;
  double max_smoothness = 0.3;
  int min_size = 100;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("max_symmetry", self.max_symmetry, "", at_least(0.0),
          "a hypothesis with a mean symmetry residual of this or more is rejected (Eq. 4.11)");
    visit("max_occlusion", self.max_occlusion, "", at_least(0.0),
          "a hypothesis with a mean occlusion residual of this or more is rejected (Eq. 4.12)");
    visit("max_smoothness", self.max_smoothness, "", at_least(0.0),
          "a hypothesis whose broken edges weigh this or more per point is rejected (Eq. 4.13)");
    visit("min_size", self.min_size, "points", at_least(1.0),
          "smaller hypotheses are rejected (section 4.3.3)");
  }
  /// Throws InputError if a bound is negative or the size below 1.
  void validate() const { check_fields(*this); }
};

/// A set of points that the graph cut found consistent with one symmetry (section 4.3).
struct Hypothesis {
  PointIndices points;  ///< into the cloud that was cut, ascending
  HypothesisResiduals residuals;
  std::optional<RotationAxis> axis = {};      ///< of the rotational stream
  std::optional<ReflectionPlane> plane = {};  ///< of the reflectional stream
};

/// The hypotheses of one stream.
struct SegmentedHypotheses {
  std::vector<Hypothesis> hypotheses;
  std::vector<Rejection> rejected;  ///< hypotheses that lost the segment that proposed them
};

/// The first bound that a hypothesis breaks, or nothing. `kind` is "rotational" or "reflectional".
std::optional<Rejection> judge(const Hypothesis& hypothesis, const HypothesisBounds& bounds,
                               const std::string& kind);

/// Confidence in [0, 1]: the geometric mean of 1 − residual / bound over the three residuals.
double confidence(const HypothesisResiduals& residuals, const HypothesisBounds& bounds);

}  // namespace symscene
