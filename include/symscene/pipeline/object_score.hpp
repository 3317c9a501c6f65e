#pragma once

#include "symscene/segmentation/object_measures.hpp"

namespace symscene {

/// The probability that a set of points is one whole object (that it overlaps with a true one by
/// more than 0.9), as boosted trees (Friedman 2001) estimate it from its measures. The trees were
/// fitted by `symscene_fit_object_score` to simulated scenes of the tune split.
double estimated_probability(const ObjectMeasures& measures);

/// How far the confidence of a cut is believed by itself.
inline constexpr double cut_belief = 0.5;

/// The estimate, raised by the confidence of the cut (which the estimate knows too): things unlike
/// those that the trees were fitted to are still found by their symmetry.
inline double combined_score(double estimate, double confidence, double belief = cut_belief) {
  return 1.0 - (1.0 - estimate) * (1.0 - belief * confidence);
}

/// The score of a proposal: both together. In [0, 1].
double object_score(const ObjectMeasures& measures);

}  // namespace symscene
