#include "proposals/object_score.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "random_features.hpp"

namespace symscene {
namespace {

/// A carton apart from others, cut out under two mirror planes.
ObjectFeatures carton() {
  return {.size = 7.15,
          .broken = 0.6,
          .torn = 0.4,
          .rim = 0.5,
          .bend = 0.018,
          .crease = 0.008,
          .seam = 0.14,
          .unity = 1.0,
          .convexity = 0.87,
          .empty = 0.0,
          .length = 0.22,
          .width = 0.08,
          .thickness = 0.06,
          .foot = 0.0005,
          .top = 0.21,
          .near_others = 0.07,
          .planes = 2.0,
          .plane_inlier = 0.54,
          .plane_occlusion = 0.0,
          .continued = 0.01,
          .confidence = 0.84};
}

/// A larger object with a concave surface.
ObjectFeatures toy() {
  ObjectFeatures features = carton();
  features.size = 7.8;
  features.torn = 0.24;
  features.rim = 0.97;
  features.bend = 0.034;
  features.crease = 0.018;
  features.seam = 0.3;
  features.convexity = 0.77;
  features.empty = 0.012;
  features.length = 0.26;
  features.width = 0.19;
  features.thickness = 0.13;
  features.top = 0.25;
  features.plane_inlier = 0.5;
  return features;
}

/// One face of a carton: a smooth surface continues all around it.
ObjectFeatures face() {
  ObjectFeatures features;
  features.size = 7.4;
  features.broken = 11.8;
  features.torn = 0.87;
  features.rim = 5.3;
  features.bend = 0.004;
  features.unity = 1.0;
  features.convexity = 0.92;
  features.length = 0.23;
  features.width = 0.2;
  features.thickness = 0.006;
  features.foot = 0.07;
  features.top = 0.28;
  features.near_others = 0.36;
  return features;
}

/// Halves of two objects that touch.
ObjectFeatures halves_of_two() {
  ObjectFeatures features = face();
  features.size = 7.1;
  features.broken = 17.4;
  features.torn = 0.98;
  features.rim = 11.7;
  features.bend = 0.0125;
  features.convexity = 0.15;
  features.empty = 0.35;
  features.length = 0.265;
  features.width = 0.126;
  features.thickness = 0.11;
  features.foot = 0.003;
  features.top = 0.105;
  features.near_others = 0.55;
  return features;
}

/// A patch of some larger surface.
ObjectFeatures patch() {
  ObjectFeatures features = face();
  features.size = 4.8;
  features.broken = 16.0;
  features.torn = 1.0;
  features.length = 0.05;
  features.width = 0.05;
  features.foot = 0.1;
  features.near_others = 0.93;
  return features;
}

TEST(ObjectScore, RisesWithTheConfidenceOfTheCut) {
  for (const double estimate : {0.0, 0.1, 0.5, 0.9, 0.99}) {
    double last = -1.0;
    for (const double confidence : {0.0, 0.1, 0.4, 0.7, 1.0}) {
      const double score = combined_score(estimate, confidence, 0.6);
      EXPECT_GT(score, last);
      EXPECT_GE(score, estimate - 1e-12);
      EXPECT_LT(score, 1.0);
      last = score;
    }
  }
}

// Probabilities from the tables of version 0.1.0, before they became the files in models/.
constexpr std::array alone_reference{
    0.0022366827679458938, 0.014369207833343245, 0.022741626573081718,  0.0057943576676798845,
    0.0075124952034241969, 0.002310711586032718, 0.014669222637975415,  0.0029225847882115288,
    0.023445570005307042,  0.065879291918838581, 0.012059402396306889,  0.0051830575687885332,
    0.36798173602557416,   0.013528575302738903, 0.034179275741800255,  0.022179576827001824,
    0.024535510457359057,  0.0164460493397936,   0.015401865472593141,  0.0045310114731037026,
    0.0075619778418092032, 0.074361838343507,    0.0096610485625356502, 0.0072384085581975836};
constexpr std::array among_others_reference{
    0.14891270864035711,    0.032880514269907353,   0.0058647746022374046, 0.0014926290806432083,
    0.86063968466943241,    0.003297883058960201,   0.076942112349541,     0.7819047210456358,
    0.00051022520517400897, 0.041623360920285686,   0.65606078738890961,   0.0016773919147448624,
    0.24196643437089502,    0.038798633774894446,   0.0051938148255712057, 0.34233390899463567,
    0.094322777363095495,   0.0084889076544197445,  0.56390750499844078,   0.31444946775995641,
    0.9724022606593643,     0.00046322427494573386, 0.0032787081670908745, 0.0080017429684970543};

TEST(ObjectScore, OfTheEmbeddedModelsIsThatOfTheFormerTables) {
  Random alone(29), among_others(29);
  for (const double expected : alone_reference) {
    const auto features = testing::random_features<ObjectFeatures>(alone);
    EXPECT_DOUBLE_EQ(estimated_probability(features), expected);
  }
  for (const double expected : among_others_reference) {
    const auto features = testing::random_features<ObjectFeatures>(among_others);
    const auto context = testing::random_features<ProposalContext>(among_others);
    EXPECT_DOUBLE_EQ(estimated_probability(features, context), expected);
  }
}

TEST(ObjectScore, IsAProbabilityForAnyFeatures) {
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

TEST(ObjectScore, IsAProbabilityForExtremeFeatures) {
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

TEST(ObjectScore, IsHighForObjectsAndLowForOtherProposals) {
  for (const ObjectFeatures& object : {carton(), toy()})
    EXPECT_GT(estimated_probability(object), 0.7);
  for (const ObjectFeatures& other : {face(), halves_of_two(), patch()})
    EXPECT_LT(estimated_probability(other), 0.1);
}

TEST(ObjectScore, IsLowerForAnObjectInPieces) {
  ObjectFeatures pieces = carton();
  pieces.unity = 0.4;
  pieces.seam = 0.95;
  pieces.crease = 0.1;
  pieces.convexity = 0.3;
  pieces.empty = 0.3;
  EXPECT_LT(estimated_probability(pieces), estimated_probability(carton()) - 0.2);
}

TEST(ObjectScore, AmongOthersIsHighForAnObjectOfUnlikelyParts) {
  ProposalContext context;
  context.estimate = 0.94;
  context.part = 0.2;
  context.covered = 0.3;
  context.covered_score = 0.06;
  context.pieces = 1.0;
  context.parts = std::log(4.0);
  EXPECT_GT(estimated_probability(carton(), context), 0.7);
}

TEST(ObjectScore, AmongOthersIsLowForAPartOfALikelyWhole) {
  ProposalContext part;
  part.estimate = 0.1;
  part.whole = 0.97;
  part.whole_share = 0.3;
  part.wholes = std::log(4.0);
  EXPECT_LT(estimated_probability(face(), part), 0.1);
  ProposalContext alone = part;
  alone.whole = alone.whole_share = alone.wholes = 0.0;
  EXPECT_LT(estimated_probability(carton(), part), estimated_probability(carton(), alone));
}

}  // namespace
}  // namespace symscene
