#include "proposals/score_effects.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/median.hpp"
#include "proposals/object_score.hpp"

namespace symscene {
namespace {

constexpr std::size_t own_features = field_count<ObjectFeatures>;
constexpr std::size_t own_estimate = own_features;  // the first field of ProposalContext
constexpr std::ptrdiff_t most_effects = 3;          // in each direction
constexpr double least_effect = 0.05;               // of log-odds

ScoreInputs inputs_of(const ObjectProposal& proposal) {
  return values_of(proposal.features, proposal.context);
}

/// The log-odds of the score that a proposal with these features has.
double log_odds_of(ScoreInputs inputs, const ScoreModels& models) {
  const double alone = models.alone.probability(std::span(inputs).first(own_features));
  inputs[own_estimate] = alone;
  const double score =
      pooled_probability(alone, models.among_others.probability(inputs), models.own_weight);
  return log_odds(score);
}

std::vector<ScoreEffect> all_effects(const ScoreInputs& inputs, const ScoreInputs& medians,
                                     const ScoreModels& models) {
  static const std::vector<std::string> names = names_of<ObjectFeatures, ProposalContext>();
  const double own = log_odds_of(inputs, models);
  std::vector<ScoreEffect> effects;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    if (k == own_estimate || inputs.at(k) == medians.at(k)) continue;
    ScoreInputs usual = inputs;
    usual.at(k) = medians.at(k);
    const double effect = own - log_odds_of(usual, models);
    if (std::abs(effect) < least_effect) continue;
    effects.push_back({names[k], inputs.at(k), medians.at(k), effect});
  }
  return effects;
}

}  // namespace

ScoreInputs median_inputs(std::span<const ObjectProposal> proposals) {
  std::vector<ScoreInputs> inputs;
  for (const ObjectProposal& proposal : proposals) inputs.push_back(inputs_of(proposal));
  ScoreInputs medians{};
  for (std::size_t k = 0; k < medians.size(); ++k) {
    std::vector<double> values;
    for (const ScoreInputs& own : inputs) values.push_back(own.at(k));
    medians.at(k) = median(std::move(values)).value_or(0.0);
  }
  return medians;
}

std::vector<ScoreEffect> score_effects(const ObjectProposal& proposal, const ScoreInputs& medians,
                                       const ScoreModels& models) {
  std::vector<ScoreEffect> effects = all_effects(inputs_of(proposal), medians, models);
  std::stable_sort(effects.begin(), effects.end(),
                   [](const ScoreEffect& a, const ScoreEffect& b) { return a.effect > b.effect; });
  const auto first_against = std::find_if(
      effects.begin(), effects.end(), [](const ScoreEffect& each) { return each.effect < 0.0; });
  const auto raising = std::min(most_effects, std::distance(effects.begin(), first_against));
  const auto lowering = std::min(most_effects, std::distance(first_against, effects.end()));
  std::vector<ScoreEffect> strongest(effects.begin(), effects.begin() + raising);
  strongest.insert(strongest.end(), effects.end() - lowering, effects.end());
  return strongest;
}

}  // namespace symscene
