#include "picking/failed_attempts.hpp"

#include <gtest/gtest.h>

namespace symscene {
namespace {

TEST(FailedAttempts, AreCountedAtAPlaceWithinTheRadiusOnly) {
  FailedAttempts failed(0.02);
  failed.add({0.0, 0.0, 0.1});
  failed.add({0.01, 0.0, 0.1});
  failed.add({0.5, 0.0, 0.1});
  EXPECT_EQ(failed.at({0.005, 0.0, 0.1}), 2);
  EXPECT_EQ(failed.at({0.5, 0.01, 0.1}), 1);
  EXPECT_EQ(failed.at({0.0, 0.0, 0.2}), 0);
}

TEST(FailedAttempts, AreCountedOnAnObjectWhereverTheyTouchedItButNotOnItsNeighbour) {
  FailedAttempts failed(0.02);
  failed.add({0.0, 0.0, 0.21});  // just above it
  failed.add({0.09, 0.0, 0.1});  // in it
  const Box object{{-0.1F, -0.05F, 0.0F}, {0.1F, 0.05F, 0.2F}};
  const Box neighbour{{0.15F, -0.05F, 0.0F}, {0.2F, 0.05F, 0.2F}};
  EXPECT_EQ(failed.in(object), 2);
  EXPECT_EQ(failed.in(neighbour), 0);
}

}  // namespace
}  // namespace symscene
