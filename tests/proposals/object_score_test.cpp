#include "proposals/object_score.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/random.hpp"

namespace symscene {
namespace {

/// What a clear object measures: in one piece, apart from others, under a symmetry that fits.
ObjectFeatures clear_object() {
  ObjectFeatures features;
  features.size = std::log(2000.0);
  features.unity = 1.0;
  features.convexity = 0.95;
  features.length = 0.2;
  features.width = 0.12;
  features.thickness = 0.1;
  features.foot = 0.005;
  features.top = 0.2;
  features.axes = 1.0;
  features.axis_misfit = 0.01;
  features.axis_occlusion = 0.001;
  return features;
}

TEST(ObjectScore, CombinesWhatTwoWitnessesSay) {
  EXPECT_DOUBLE_EQ(combined_score(0.2, 0.0), 0.2);
  EXPECT_DOUBLE_EQ(combined_score(0.2, 0.6, 0.5), 0.44);  // 1 − 0.8 · 0.7
  EXPECT_DOUBLE_EQ(combined_score(0.0, 1.0), cut_belief);
  EXPECT_DOUBLE_EQ(combined_score(1.0, 0.3), 1.0);
}

TEST(ObjectScore, RisesWithTheConfidenceOfTheCut) {
  for (const double estimate : {0.0, 0.1, 0.5, 0.9, 0.99}) {
    double last = -1.0;
    for (const double confidence : {0.0, 0.1, 0.4, 0.7, 1.0}) {
      const double score = combined_score(estimate, confidence);
      EXPECT_GT(score, last);
      EXPECT_GE(score, estimate - 1e-12);
      EXPECT_LT(score, 1.0);
      last = score;
    }
  }
}

TEST(ObjectScore, IsAProbabilityWhateverIsMeasured) {
  Random random(7);
  const auto anything = [&](const char*, double& value) { value = random.uniform(-1.0, 10.0); };
  for (int k = 0; k < 500; ++k) {
    ObjectFeatures features;
    ProposalContext context;
    ObjectFeatures::visit_fields(features, anything);
    ProposalContext::visit_fields(context, anything);
    for (const double estimate :
         {estimated_probability(features), estimated_probability(features, context)}) {
      EXPECT_GT(estimate, 0.0);
      EXPECT_LT(estimate, 1.0);
    }
  }
}

TEST(ObjectScore, EndsForValuesOutOfAllBounds) {
  for (const double value : {-1e300, 1e300, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
    const auto set = [&](const char*, double& field) { field = value; };
    ObjectFeatures features;
    ProposalContext context;
    ObjectFeatures::visit_fields(features, set);
    ProposalContext::visit_fields(context, set);
    EXPECT_GT(estimated_probability(features, context), 0.0);
    EXPECT_LT(estimated_probability(features, context), 1.0);
  }
}

TEST(ObjectScore, OfAClearObjectIsHighAndOfOneInPiecesLower) {
  const ObjectFeatures whole = clear_object();
  ObjectFeatures pieces = whole;
  pieces.unity = 0.4;
  pieces.seam = 0.95;
  pieces.crease = 0.1;
  pieces.convexity = 0.6;
  pieces.empty = 0.3;
  EXPECT_GT(estimated_probability(whole), 0.3);
  EXPECT_LT(estimated_probability(pieces), estimated_probability(whole));
}

TEST(ObjectScore, OfAPartFallsWithTheWholeThatHoldsIt) {
  const ObjectFeatures features = clear_object();
  ProposalContext alone;
  alone.estimate = 0.6;
  ProposalContext part = alone;
  part.whole = 0.97;
  part.whole_share = 0.3;
  part.wholes = std::log(4.0);
  EXPECT_GT(estimated_probability(features, alone), estimated_probability(features, part));
}

}  // namespace
}  // namespace symscene
