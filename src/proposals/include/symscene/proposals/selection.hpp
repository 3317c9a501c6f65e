#pragma once

#include "symscene/core/options.hpp"
#include "symscene/core/scene.hpp"

namespace symscene {

struct SelectionOptions {
  bool by_score = true;  ///< choose among all proposals by their estimated probability; otherwise
                         ///< among the cuts within the bounds of section 4.3.3, by size and score
  double min_score = 0.45;       ///< least probability of an object
  double max_overlap = 0.5;      ///< of two objects that share more of the smaller one, one goes
  double min_parts_cover = 0.9;  ///< an object is a composite if smaller ones hold this share of it
  double score_exponent = 1.0;   ///< an object is worth its size times this power of its score

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("by_score", self.by_score, "",
          "choose among all proposals by probability, not among cuts within bounds");
    visit("min_score", self.min_score, "", "least probability of an object, with by_score");
    visit("max_overlap", self.max_overlap, "",
          "of two objects that share more of the smaller one, one goes");
    visit("min_parts_cover", self.min_parts_cover, "",
          "without by_score, an object goes if others inside it hold this share of it");
    visit("score_exponent", self.score_exponent, "",
          "without by_score, an object is worth its size times this power of its score");
  }
  /// Throws InputError on a share outside [0, 1] or a negative exponent.
  void validate() const;
};

/// The objects of a scene that explain most of it without explaining the same points twice. An
/// object that others inside it make up (two boxes side by side mirror one another and pass as one)
/// goes with reason "composite". Of all sets of the rest without two that overlap too much, the one
/// of the greatest worth stays (a maximum-weight independent set, exact for up to 24 rivals and
/// greedy beyond); what goes does so with reason "overlap". Keeps the order.
std::vector<SceneObject> select_consistent(std::vector<SceneObject> objects,
                                           const SelectionOptions& options,
                                           std::vector<Rejection>& rejected);

/// The set of objects, no two of which overlap too much, whose probabilities exceed the least one
/// by most in sum: what a set is expected to gain where a wrong object costs `min_score` (exact for
/// up to 24 rivals, by local search beyond). What goes does so with reason "score" or "overlap".
/// Keeps the order.
std::vector<SceneObject> select_probable(std::vector<SceneObject> objects,
                                         const SelectionOptions& options,
                                         std::vector<Rejection>& rejected);

}  // namespace symscene
