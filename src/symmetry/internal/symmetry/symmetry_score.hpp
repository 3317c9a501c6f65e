#pragma once

#include "symmetry/axis_features.hpp"
#include "symmetry/plane_features.hpp"
#include "symscene/core/tree_model.hpp"

namespace symscene {

/// The embedded models models/axis.txt and models/plane.txt, parsed on first use. They were fitted
/// by `symscene_fit_symmetry_score` to simulated scenes of the training split, to axes and planes
/// within ObjectSymmetryOptions alone: others may get any probability, so check the bounds first.
const TreeModel& axis_model();
const TreeModel& plane_model();

/// The probability that an object is a body of revolution about an axis.
double axis_probability(const AxisFeatures& features, const TreeModel& model = axis_model());

/// The probability that a plane is a mirror plane of an object.
double plane_probability(const PlaneFeatures& features, const TreeModel& model = plane_model());

}  // namespace symscene
