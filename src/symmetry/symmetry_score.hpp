#pragma once

#include "symmetry/axis_features.hpp"
#include "symmetry/plane_features.hpp"

namespace symscene {

/// The probability that an object is a body of revolution about an axis, and that a plane is a
/// mirror of it, as boosted trees (Friedman 2001) estimate them from measures. The trees were
/// fitted by `symscene_fit_symmetry_score` to simulated scenes of the tune split.
double axis_probability(const AxisFeatures& features);
double plane_probability(const PlaneFeatures& features);

}  // namespace symscene
