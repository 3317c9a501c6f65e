#pragma once

#include <optional>
#include <string>
#include <vector>

#include "symscene/core/scene.hpp"
#include "symscene/segmentation/graph_cut.hpp"

namespace symscene {

/// Measures of a segment under the symmetry that cut it out (section 4.3.3). Lower is better.
struct HypothesisScores {
  double symmetry = 0.0;   ///< Eq. 4.11, in [0, 1]
  double occlusion = 0.0;  ///< Eq. 4.12, in [0, 1]
  double smoothness =
      0.0;  ///< weight of the edges that the cut broke, a point of the segment (Eq. 4.13 as used)
};

/// The bounds beyond which a segment is no object (section 4.3.3).
struct HypothesisBounds {
  double max_symmetry = 0.03;
  double max_occlusion = 0.015;
  double max_smoothness = 0.3;
  int min_size = 100;  ///< [points]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("max_symmetry", self.max_symmetry, "", "greatest mean symmetry score of an object");
    visit("max_occlusion", self.max_occlusion, "", "greatest mean occlusion score of an object");
    visit("max_smoothness", self.max_smoothness, "", "greatest weight of broken edges a point");
    visit("min_size", self.min_size, "points", "least size of an object");
  }
  /// Throws InputError on a bound that is negative or a size below 1.
  void validate() const;
};

/// A set of points that one symmetry explains.
struct Hypothesis {
  PointIndices points;  ///< into the cloud that was cut, ascending
  HypothesisScores scores;
  std::vector<ScoredAxis> rotational;     ///< one, or none
  std::vector<ScoredPlane> reflectional;  ///< one, or none
};

/// What the cuts of one stream left.
struct HypothesisSet {
  std::vector<Hypothesis> hypotheses;
  std::vector<Rejection> rejected;  ///< cuts that lost what proposed them
};

/// The first bound that a segment breaks, or nothing.
std::optional<Rejection> judge(const Hypothesis& hypothesis, const HypothesisBounds& bounds,
                               const std::string& kind);

/// Confidence in [0, 1]: the geometric mean of how far each score stays from its bound.
double confidence(const HypothesisScores& scores, const HypothesisBounds& bounds);

/// The weight of the broken edges a point of the object (Eq. 4.13 as used); `edges` carry the λ of
/// the cut.
double smoothness(const std::vector<std::uint8_t>& is_object, std::span<const WeightedEdge> edges);

/// For every node the number of its connected component over the edges between nodes that are both
/// object; components count from 0 by their lowest node, and `no_component` stands at nodes that
/// are background.
inline constexpr Index no_component = ~Index{0};
std::vector<Index> connected_components(const std::vector<std::uint8_t>& is_object,
                                        std::span<const WeightedEdge> edges);

/// The nodes labelled object, ascending.
PointIndices object_nodes(const std::vector<std::uint8_t>& is_object);

}  // namespace symscene
