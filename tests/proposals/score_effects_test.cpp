#include "proposals/score_effects.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "proposals/object_score.hpp"

namespace symscene {
namespace {

const ScoreModels models{object_model(), object_context_model(), 0.5};

double log_odds_of(const ObjectProposal& proposal) {
  ProposalContext context = proposal.context;
  context.estimate = estimated_probability(proposal.features);
  return log_odds(
      pooled_probability(context.estimate, estimated_probability(proposal.features, context), 0.5));
}

/// A convex thing in one piece beside two that are not.
std::vector<ObjectProposal> proposals() {
  std::vector<ObjectProposal> all(3);
  for (ObjectProposal& each : all) {
    each.features.convexity = 0.5;
    each.features.fold = 0.6;
    each.features.plane_occlusion = 1.0;
  }
  all[0].features.convexity = 0.99;
  all[0].features.unity = all[0].features.near_unity = 1.0;
  all[0].features.plane_occlusion = 0.0;
  all[0].features.plane_inlier = 0.9;
  all[0].features.planes = 2.0;
  all[0].features.fold = 0.01;
  return all;
}

TEST(ScoreEffects, AreDifferencesOfLogOddsFromTheMedian) {
  const std::vector<ObjectProposal> all = proposals();
  const ScoreInputs medians = median_inputs(all);
  const std::vector<ScoreEffect> effects = score_effects(all[0], medians, models);
  ASSERT_FALSE(effects.empty());
  for (const ScoreEffect& each : effects) {
    ObjectProposal usual = all[0];
    const auto replace = [&](const char* name, double& value) {
      if (each.feature == name) value = each.median;
    };
    ObjectFeatures::visit_fields(usual.features, replace);
    ProposalContext::visit_fields(usual.context, replace);
    EXPECT_NEAR(each.effect, log_odds_of(all[0]) - log_odds_of(usual), 1e-9) << each.feature;
  }
}

TEST(ScoreEffects, FallAndAreAtMostThreeInEachDirection) {
  const std::vector<ObjectProposal> all = proposals();
  const std::vector<ScoreEffect> effects = score_effects(all[0], median_inputs(all), models);
  EXPECT_TRUE(std::is_sorted(effects.begin(), effects.end(),
                             [](const auto& a, const auto& b) { return a.effect > b.effect; }));
  const auto raising = std::count_if(effects.begin(), effects.end(),
                                     [](const auto& each) { return each.effect > 0.0; });
  EXPECT_GT(raising, 0);
  EXPECT_LE(raising, 3);
  EXPECT_LE(static_cast<std::ptrdiff_t>(effects.size()) - raising, 3);
}

TEST(ScoreEffects, OfAProposalAloneAreNone) {
  const std::vector<ObjectProposal> all(1, proposals()[0]);
  EXPECT_TRUE(score_effects(all[0], median_inputs(all), models).empty());
}

}  // namespace
}  // namespace symscene
