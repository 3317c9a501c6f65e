#pragma once

#include "symscene/core/grasp.hpp"

namespace symscene {

/// The probability that a grasp with these features succeeds: a logistic model.
double success_probability(const GraspFeatures& features);

}  // namespace symscene
