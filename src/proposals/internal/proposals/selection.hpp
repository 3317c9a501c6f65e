#pragma once

#include <vector>

#include "symscene/core/scene.hpp"
#include "symscene/proposals/selection_options.hpp"

namespace symscene {

/// Chooses among hypotheses within the bounds of section 4.3.3. First, composites are rejected:
/// objects that others inside them make up (two boxes side by side mirror each other and pass as
/// one). Of the rest the choice is a maximum-weight independent set of the conflict graph, weighted
/// by size and score; the others are rejected with the reason "overlap". `objects` come by falling
/// score; the order is kept.
std::vector<SceneObject> select_consistent(std::vector<SceneObject> objects,
                                           const SelectionOptions& options,
                                           std::vector<Rejection>& rejected);

/// Chooses the subset that maximises sum(score - min_score) such that no two members share more
/// than `max_overlap` of the smaller one's points. This is the greatest expected gain if a wrong
/// object costs `min_score`. Where this subset leaves points uncovered, less likely objects are
/// chosen in the same way with a bound of uncovered_ratio * min_score, unless they are fragments
/// (`uncovered_size`): what stands on a table belongs to some object. The others are rejected with
/// the reason "score" or "overlap". The order is kept, less likely objects last.
std::vector<SceneObject> select_probable(std::vector<SceneObject> objects,
                                         const SelectionOptions& options,
                                         std::vector<Rejection>& rejected);

}  // namespace symscene
