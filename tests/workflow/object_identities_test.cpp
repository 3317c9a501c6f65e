#include "symscene/workflow/object_identities.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// A result whose objects are balls of points, and points of no object.
struct Balls {
  SegmentationResult result;
  std::vector<Eigen::Vector3f> positions;

  Balls& ball(float x, float radius = 0.04F, bool is_object = true, float shift = 0.0F) {
    SceneObject object;
    constexpr int points = 800;
    for (int k = 0; k < points; ++k) {
      const float z = 1.0F - (2.0F * static_cast<float>(k) + 1.0F) / points;
      const float angle = 2.3999632F * static_cast<float>(k) + shift;
      const float r = std::sqrt(1.0F - z * z);
      if (is_object) object.points.push_back(static_cast<Index>(positions.size()));
      positions.emplace_back(x + radius * r * std::cos(angle), radius * r * std::sin(angle),
                             radius * z);
    }
    if (is_object) result.objects.push_back(std::move(object));
    return *this;
  }

  SegmentationResult done() {
    result.cloud.positions.resize(static_cast<Eigen::Index>(positions.size()), 3);
    for (std::size_t i = 0; i < positions.size(); ++i)
      result.cloud.positions.row(static_cast<Eigen::Index>(i)) = positions[i].transpose();
    return std::move(result);
  }
};

std::vector<std::string> told(const IdentifiedObjects& identified) {
  std::vector<std::string> changes;
  for (const ObjectChange& change : identified.changes)
    changes.push_back(std::to_string(change.number) + " " + to_string(change.kind));
  return changes;
}

using Numbers = std::vector<ObjectNumber>;
using Told = std::vector<std::string>;

TEST(ObjectIdentities, ObjectsKeepTheirNumbersInAnyOrderOfTheResult) {
  ObjectIdentities identities;
  const IdentifiedObjects first =
      identities.identify(Balls().ball(0.0F).ball(0.2F).ball(0.4F).done());
  EXPECT_EQ(first.numbers, (Numbers{1, 2, 3}));
  EXPECT_EQ(told(first), (Told{"1 appeared", "2 appeared", "3 appeared"}));
  // Measured anew: other points of the same surfaces, a few millimetres away.
  const IdentifiedObjects second = identities.identify(
      Balls().ball(0.403F, 0.04F, true, 1.0F).ball(0.002F, 0.041F, true, 0.5F).ball(0.2F).done());
  EXPECT_EQ(second.numbers, (Numbers{3, 1, 2}));
  EXPECT_TRUE(second.changes.empty());
}

TEST(ObjectIdentities, WhatIsTakenAwayIsGoneOnceAndItsNumberIsNotUsedForAnother) {
  ObjectIdentities identities;
  identities.identify(Balls().ball(0.0F).ball(0.2F).done());
  const IdentifiedObjects without = identities.identify(Balls().ball(0.0F).done());
  EXPECT_EQ(told(without), (Told{"2 gone"}));
  EXPECT_TRUE(identities.identify(Balls().ball(0.0F).done()).changes.empty());
  const IdentifiedObjects other = identities.identify(Balls().ball(0.0F).ball(0.4F).done());
  EXPECT_EQ(told(other), (Told{"3 appeared"}));
}

TEST(ObjectIdentities, WhatIsPutBackIsTheSameObject) {
  ObjectIdentities identities;
  identities.identify(Balls().ball(0.0F).ball(0.2F).done());
  identities.identify(Balls().ball(0.0F).done());
  EXPECT_EQ(told(identities.identify(Balls().ball(0.2F).ball(0.0F).done())), (Told{"2 returned"}));
}

TEST(ObjectIdentities, AnObjectThatIsAwayForLongIsForgotten) {
  ObjectIdentityOptions options;
  options.max_absence = 3;
  ObjectIdentities identities(options);
  identities.identify(Balls().ball(0.0F).ball(0.2F).done());
  for (int k = 0; k < 2; ++k) identities.identify(Balls().ball(0.0F).done());
  EXPECT_EQ(told(identities.identify(Balls().ball(0.0F).ball(0.2F).done())), (Told{"2 returned"}));
  for (int k = 0; k < 3; ++k) identities.identify(Balls().ball(0.0F).done());
  EXPECT_EQ(told(identities.identify(Balls().ball(0.0F).ball(0.2F).done())), (Told{"3 appeared"}));
}

TEST(ObjectIdentities, AnObjectWhosePointsAreThereButNotAsAnObjectIsUnclear) {
  ObjectIdentities identities;
  identities.identify(Balls().ball(0.0F).ball(0.2F).done());
  EXPECT_EQ(told(identities.identify(Balls().ball(0.0F).ball(0.2F, 0.04F, false).done())),
            (Told{"2 unclear"}));
  EXPECT_EQ(told(identities.identify(Balls().ball(0.0F).done())), (Told{"2 gone"}));
}

TEST(ObjectIdentities, TheLargerPartOfAMergedObjectKeepsItsNumber) {
  ObjectIdentities identities;
  identities.identify(Balls().ball(0.0F, 0.06F).ball(0.09F, 0.03F).done());
  Balls merged;
  merged.ball(0.0F, 0.06F).ball(0.09F, 0.03F);
  PointIndices& all = merged.result.objects[0].points;
  const PointIndices& other = merged.result.objects[1].points;
  all.insert(all.end(), other.begin(), other.end());
  merged.result.objects.pop_back();
  const IdentifiedObjects identified = identities.identify(merged.done());
  EXPECT_EQ(identified.numbers, (Numbers{1}));
  EXPECT_EQ(told(identified), (Told{"2 unclear"}));
}

TEST(ObjectIdentities, AScaledSceneHasTheSameNumbers) {
  for (const float scale : {0.2F, 1.0F, 8.0F}) {
    ObjectIdentities identities;
    identities.identify(Balls().ball(0.0F, 0.04F * scale).ball(0.2F * scale, 0.04F * scale).done());
    const IdentifiedObjects identified = identities.identify(
        Balls().ball(0.202F * scale, 0.04F * scale).ball(0.6F * scale, 0.04F * scale).done());
    EXPECT_EQ(identified.numbers, (Numbers{2, 3})) << scale;
    EXPECT_EQ(told(identified), (Told{"1 gone", "3 appeared"})) << scale;
  }
}

TEST(ObjectIdentities, AnEmptyResultEndsAllObjects) {
  ObjectIdentities identities;
  EXPECT_TRUE(identities.identify({}).changes.empty());
  identities.identify(Balls().ball(0.0F).done());
  EXPECT_EQ(told(identities.identify({})), (Told{"1 gone"}));
}

TEST(ObjectIdentities, OptionsOutOfTheirRangeAreRefused) {
  ObjectIdentityOptions options;
  options.min_overlap = 1.5;
  EXPECT_THROW(ObjectIdentities{options}, InputError);
}

}  // namespace
}  // namespace symscene
