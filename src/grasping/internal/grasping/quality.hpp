#pragma once

#include <Eigen/Core>

#include "symscene/core/grasp.hpp"

namespace symscene {

/// One value per input of the logistic model of a grasp's success.
using QualityVector = Eigen::Matrix<double, 14, 1>;

/// The inputs of the model, each in [0, 1]: 1 (for the bias), whether a symmetry proposed the
/// grasp, and the features, mapped linearly from the bounds beyond which they no longer matter.
QualityVector quality_inputs(const Grasp& grasp);

/// The weights of the inputs: fitted by `symscene_fit_grasp_quality` to outcomes in physics.
QualityVector quality_weights();

/// Weights that were set by hand: the mean of the fit's prior.
QualityVector prior_quality_weights();

/// The logistic function.
double logistic(double log_odds);

/// The probability that a grasp with these features and this source succeeds.
double success_probability(const Grasp& grasp);

}  // namespace symscene
