#pragma once

#include "symscene/core/grasp.hpp"

namespace symscene {

/// A weighted sum of a grasp's features that ranks grasps; its weights are set by hand.
double quality_score(const Grasp& grasp);

/// The logistic function.
double logistic(double log_odds);

/// The probability that a grasp succeeds: the logistic function of its score, scaled and shifted
/// (Platt 1999) to the outcomes of grasps in physics by `symscene_fit_grasp_quality`.
double success_probability(const Grasp& grasp);

}  // namespace symscene
