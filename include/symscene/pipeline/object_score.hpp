#pragma once

#include "symscene/segmentation/object_measures.hpp"

namespace symscene {

/// The probability that a set of points is one whole object (that it overlaps with a true one by
/// more than 0.9), as boosted trees (Friedman 2001) estimate it from its measures. The trees were
/// fitted by `symscene_fit_object_score` to simulated scenes of the tune split.
double object_score(const ObjectMeasures& measures);

}  // namespace symscene
