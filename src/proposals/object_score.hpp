#pragma once

#include "proposal_context.hpp"
#include "symscene/proposals/object_features.hpp"

namespace symscene {

/// The probability that a set of points is one whole object (that it overlaps with a true one by
/// more than 0.9), as boosted trees (Friedman 2001) estimate it from its measures. The trees were
/// fitted by `symscene_fit_object_score` to simulated scenes of the tune split.
double estimated_probability(const ObjectFeatures& features);

/// The same, from its measures and from what the other proposals say of it.
double estimated_probability(const ObjectFeatures& features, const ProposalContext& context);

/// How far the confidence of a cut is believed by itself.
inline constexpr double cut_belief = 0.6;

/// An estimate, raised by the confidence of the cut (which the estimate knows too): things unlike
/// those that the trees were fitted to are still found by their symmetry. In [0, 1].
inline double combined_score(double estimate, double confidence, double belief = cut_belief) {
  return 1.0 - (1.0 - estimate) * (1.0 - belief * confidence);
}

}  // namespace symscene
