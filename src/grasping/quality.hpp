#pragma once

#include "symscene/core/grasp.hpp"

namespace symscene {

/// The probability that a grasp succeeds, by its features and source: a logistic model.
double success_probability(const Grasp& grasp);

}  // namespace symscene
