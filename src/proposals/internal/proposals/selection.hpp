#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "symscene/proposals/proposals.hpp"
#include "symscene/proposals/selection_options.hpp"

namespace symscene {

/// The properties of a candidate object that the selection compares.
struct SelectionCandidate {
  std::span<const Index> points;  ///< ascending; they outlive the candidate
  /// In [0, 1]: the confidence for select_consistent(), the probability for select_probable().
  double score = 0.0;
  const char* kind = "surface";  ///< Rejection::kind
};
SelectionCandidate selection_candidate(const MergedHypothesis& merged, double score);

/// Chooses among hypotheses within the bounds of section 4.3.3. First, composites are rejected:
/// objects that others inside them make up (two boxes side by side mirror each other and pass as
/// one). Of the rest the choice is a maximum-weight independent set of the conflict graph, weighted
/// by size and score; the others are rejected with the reason "overlap". `objects` come by falling
/// score. Returns ascending indices.
std::vector<std::size_t> select_consistent(const std::vector<SelectionCandidate>& objects,
                                           const SelectionOptions& options,
                                           std::vector<Rejection>& rejected);

/// Chooses the subset that maximises sum(score - min_score) such that no two members share more
/// than `max_overlap` of the smaller one's points. This is the greatest expected gain if a wrong
/// object costs `min_score`. Where this subset leaves points uncovered, less likely objects above
/// uncovered_ratio * min_score are chosen in the same way, unless they are fragments
/// (`uncovered_size`): what stands on a table belongs to some object. They maximise sum(score), as
/// a cost per object would favour an uncertain union over its uncertain parts. The others are
/// rejected with the reason "score" or "overlap". Returns ascending indices, then those of the less
/// likely objects.
std::vector<std::size_t> select_probable(const std::vector<SelectionCandidate>& objects,
                                         const SelectionOptions& options,
                                         std::vector<Rejection>& rejected);

}  // namespace symscene
