#pragma once

#include <array>
#include <span>

#include "core/model_features.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/core/tree_model.hpp"
#include "symscene/proposals/proposals.hpp"

namespace symscene {

/// The features of a proposal and of its relations to others, in the order of the models.
using ScoreInputs = std::array<double, field_count<ObjectFeatures> + field_count<ProposalContext>>;

/// The models that give proposals their scores, and how they are pooled.
struct ScoreModels {
  const TreeModel& alone;
  const TreeModel& among_others;
  double own_weight;  ///< ProposalContextOptions
};

/// The median of each feature over the proposals; zeros without proposals.
ScoreInputs median_inputs(std::span<const ObjectProposal> proposals);

/// The features that moved the score of a proposal most: at most three that raised it and at most
/// three that lowered it, by falling effect. The proposal's own estimate is not listed: its effect
/// is that of the features that it is made of.
std::vector<ScoreEffect> score_effects(const ObjectProposal& proposal, const ScoreInputs& medians,
                                       const ScoreModels& models);

}  // namespace symscene
