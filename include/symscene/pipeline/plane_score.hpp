#pragma once

#include "symscene/pipeline/plane_measures.hpp"

namespace symscene {

/// The probability that a plane is a mirror of an object, as boosted trees (Friedman 2001) estimate
/// it from its measures. The trees were fitted by `symscene_fit_plane_score` to simulated scenes of
/// the tune split.
double plane_probability(const PlaneMeasures& measures);

}  // namespace symscene
