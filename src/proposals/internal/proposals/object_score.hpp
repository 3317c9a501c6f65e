#pragma once

#include "proposals/proposal_context.hpp"
#include "symscene/core/tree_model.hpp"
#include "symscene/proposals/object_features.hpp"

namespace symscene {

/// The embedded models models/object_alone.txt and models/object_among_others.txt, parsed on first
/// use. They were fitted by `symscene_fit_object_score` to simulated scenes of the training split.
const TreeModel& object_model();
const TreeModel& object_context_model();

/// The probability that a proposal is one whole object (IoU above 0.9 with an object of the ground
/// truth), estimated from its own features.
double estimated_probability(const ObjectFeatures& features,
                             const TreeModel& model = object_model());

/// The same, estimated from its own features and its relations to the scene's other proposals.
double estimated_probability(const ObjectFeatures& features, const ProposalContext& context,
                             const TreeModel& model = object_context_model());

/// ln(p / (1 - p)), finite for certain events too.
double log_odds(double probability);

/// The logarithmic opinion pool of two probabilities (Genest and Zidek 1986): the mean of their
/// log-odds, the first with weight `weight_a`, the second with the rest.
double pooled_probability(double a, double b, double weight_a);

}  // namespace symscene
