#include "proposals/object_score.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "random_features.hpp"

namespace symscene {
namespace {

/// A carton apart from others, cut out under two mirror planes.
ObjectFeatures carton() {
  const OwnFeatures own{.broken = 0.6,
                        .torn = 0.4,
                        .rim = 0.5,
                        .bend = 0.018,
                        .crease = 0.008,
                        .seam = 0.14,
                        .fold = 0.03,
                        .fold_rim = 0.9,
                        .unity = 1.0,
                        .near_unity = 1.0,
                        .convexity = 0.87,
                        .empty = 0.0,
                        .width_ratio = 0.36,
                        .thickness_ratio = 0.27,
                        .near_others = 0.07,
                        .planes = 2.0,
                        .plane_inlier = 0.54,
                        .plane_occlusion = 0.0,
                        .confidence = 0.84};
  return {own, 0.01, 0.0};
}

/// A larger object with a concave surface.
ObjectFeatures toy() {
  ObjectFeatures features = carton();
  features.torn = 0.24;
  features.rim = 0.97;
  features.bend = 0.034;
  features.crease = 0.018;
  features.seam = 0.3;
  features.convexity = 0.77;
  features.empty = 0.012;
  features.width_ratio = 0.73;
  features.thickness_ratio = 0.5;
  features.plane_inlier = 0.5;
  return features;
}

/// One face of a carton: a smooth surface continues all around it.
ObjectFeatures face() {
  ObjectFeatures features;
  features.broken = 11.8;
  features.torn = 0.87;
  features.rim = 5.3;
  features.bend = 0.004;
  features.unity = 1.0;
  features.convexity = 0.92;
  features.fold_rim = 0.05;
  features.near_unity = 1.0;
  features.width_ratio = 0.87;
  features.thickness_ratio = 0.03;
  features.near_others = 0.36;
  return features;
}

/// Halves of two objects that touch.
ObjectFeatures halves_of_two() {
  ObjectFeatures features = face();
  features.broken = 17.4;
  features.torn = 0.98;
  features.rim = 11.7;
  features.bend = 0.0125;
  features.convexity = 0.15;
  features.empty = 0.35;
  features.width_ratio = 0.48;
  features.thickness_ratio = 0.42;
  features.near_others = 0.55;
  return features;
}

/// A patch of some larger surface.
ObjectFeatures patch() {
  ObjectFeatures features = face();
  features.broken = 16.0;
  features.torn = 1.0;
  features.width_ratio = 1.0;
  features.near_others = 0.93;
  return features;
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
    EXPECT_GT(estimated_probability(object), 0.5);
  for (const ObjectFeatures& other : {face(), halves_of_two(), patch()})
    EXPECT_LT(estimated_probability(other), 0.2);
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

TEST(PooledProbability, LiesBetweenBothAndIsOneOfThemWithAllTheWeight) {
  Random random(11);
  for (int k = 0; k < 200; ++k) {
    const double a = random.uniform(), b = random.uniform(), weight = random.uniform();
    const double pooled = pooled_probability(a, b, weight);
    EXPECT_GE(pooled, std::min(a, b) - 1e-12);
    EXPECT_LE(pooled, std::max(a, b) + 1e-12);
    EXPECT_NEAR(pooled_probability(a, b, 1.0), a, 1e-12);
    EXPECT_NEAR(pooled_probability(a, b, 0.0), b, 1e-12);
  }
}

TEST(PooledProbability, TreatsAnEventAndItsOppositeAlike) {
  EXPECT_NEAR(pooled_probability(0.9, 0.2, 0.3), 1.0 - pooled_probability(0.1, 0.8, 0.3), 1e-12);
}

TEST(PooledProbability, IsAProbabilityForCertainEvents) {
  EXPECT_NEAR(pooled_probability(0.0, 1.0, 0.5), 0.5, 1e-9);
  EXPECT_LT(pooled_probability(0.0, 0.0, 0.2), 1e-9);
}

}  // namespace
}  // namespace symscene
