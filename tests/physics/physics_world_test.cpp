#include "symscene/physics/physics_world.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "physics/convex_shapes.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

using testing::at;

/// The corners of a box that stands on z = 0 of its own frame.
ConvexParts standing_box(double x, double y, double z) {
  Points corners(8, 3);
  for (int k = 0; k < 8; ++k) {
    corners.row(k) << static_cast<float>(k & 1 ? 0.5 * x : -0.5 * x),
        static_cast<float>(k & 2 ? 0.5 * y : -0.5 * y), static_cast<float>(k & 4 ? z : 0.0);
  }
  return {corners};
}

class PhysicsWorldTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_physics()) GTEST_SKIP() << "skipped: this build has no physics";
  }

  const ConvexParts crate_ = standing_box(0.06, 0.1, 0.15);
  const ConvexParts slab_ = standing_box(0.2, 0.2, 0.04);
  const std::vector<const ConvexParts*> bodies_ = {&crate_, &slab_};
};

TEST_F(PhysicsWorldTest, ABodyInTheAirFallsOntoTheTableAndRests) {
  PhysicsWorld world(bodies_);
  world.put(0, at(0, 0, 0.1));
  world.advance(0.1);
  EXPECT_GT(world.speed(0), 0.5);
  world.advance(2.0);
  EXPECT_NEAR(world.pose(0).translation().z(), 0.0, 0.001);
  EXPECT_LT(world.speed(0), 0.003);
  EXPECT_LT(world.penetration(0), 0.001);
}

TEST_F(PhysicsWorldTest, ABodyRestsOnAnotherUntilThatIsTakenAway) {
  PhysicsWorld world(bodies_);
  world.put(0, at(0, 0, 0.05));
  world.put(1, at(0, 0, 0));
  world.advance(2.0);
  EXPECT_NEAR(world.pose(0).translation().z(), 0.04, 0.002);
  world.take_away(1);
  EXPECT_FALSE(world.is_there(1));
  world.advance(2.0);
  EXPECT_NEAR(world.pose(0).translation().z(), 0.0, 0.001);
}

TEST_F(PhysicsWorldTest, BodiesAreAbsentUntilTheyArePut) {
  PhysicsWorld world(bodies_);
  EXPECT_FALSE(world.is_there(0));
  world.put(0, at(0.1, -0.2, 0.3));
  EXPECT_TRUE(world.is_there(0));
  EXPECT_FALSE(world.is_there(1));
  EXPECT_TRUE(world.pose(0).isApprox(at(0.1, -0.2, 0.3)));
}

TEST_F(PhysicsWorldTest, PenetrationIsTheDepthInTheTable) {
  PhysicsWorld world(bodies_);
  world.put(1, at(0, 0, -0.01));
  world.advance(PhysicsOptions{}.time_step);
  EXPECT_NEAR(world.penetration(1), 0.01, 0.002);
  EXPECT_EQ(world.penetration(0), 0.0);
}

TEST_F(PhysicsWorldTest, TheSameCallsGiveTheSamePosesToTheLastBit) {
  const auto fall = [&] {
    PhysicsWorld world(bodies_);
    world.put(0, at(0.05, 0.01, 0.1));
    world.put(1, at(0, 0, 0.02));
    world.advance(1.0);
    return world.pose(0);
  };
  EXPECT_EQ(fall().matrix(), fall().matrix());
}

TEST_F(PhysicsWorldTest, ASimulationThatFailsThrows) {
  PhysicsWorld world(bodies_);
  world.put(0, at(std::numeric_limits<double>::quiet_NaN(), 0, 0));
  EXPECT_THROW(world.advance(0.1), std::runtime_error);
}

TEST_F(PhysicsWorldTest, RefusesBodiesWithoutVolumeAndOptionsOutOfTheirRange) {
  const ConvexParts flat = {Points::Zero(4, 3)};
  const std::vector<const ConvexParts*> bodies = {&flat};
  EXPECT_THROW(PhysicsWorld world(bodies), InputError);
  PhysicsOptions options;
  options.time_step = 0.0;
  EXPECT_THROW(PhysicsWorld world(bodies_, options), InputError);
}

TEST(PhysicsWorldWithoutPhysics, CannotBeConstructed) {
  if (has_physics()) GTEST_SKIP() << "skipped: this build has physics";
  EXPECT_THROW(PhysicsWorld({}), InputError);
}

}  // namespace
}  // namespace symscene
