#pragma once

#include <span>

#include "symscene/core/options.hpp"
#include "symscene/segmentation/hypothesis.hpp"

namespace symscene {

struct MergeOptions {
  double same_object = 0.95;  ///< segments that overlap more are one object (section 4.4) [IoU]
  double same_angle = radians(7.0);  ///< symmetries of one object closer than this [rad]
  double same_distance = 0.01;       ///< and this, at the object, are one [m]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("same_object", self.same_object, "IoU", "segments that overlap more are one object");
    visit("same_angle", self.same_angle, "rad",
          "symmetries of an object closer than this and same_distance are one");
    visit("same_distance", self.same_distance, "m",
          "symmetries of an object closer than this and same_angle are one");
  }
  /// Throws InputError on an overlap outside [0, 1] or a negative tolerance.
  void validate() const;
};

/// A hypothesis with its confidence, its points counted in the scene's cloud.
struct RatedHypothesis {
  Hypothesis hypothesis;
  double score = 0.0;
};

/// Adds cuts with their confidence within the bounds of their stream.
void append_rated(const std::vector<Hypothesis>& cuts, const HypothesisBounds& bounds,
                  std::vector<RatedHypothesis>& rated);

/// Whether two ascending sets of points overlap by more than `same_object` [IoU].
bool is_same_set(std::span<const Index> a, std::span<const Index> b, double same_object);

/// Hypotheses that show the same object become one, which keeps the mask of the best and the
/// symmetries of all (section 4.4). By falling score.
std::vector<SceneObject> merge_hypotheses(std::vector<RatedHypothesis> hypotheses,
                                          const PointCloud& cloud,
                                          const MergeOptions& options = {});

}  // namespace symscene
