#include "symscene/physics/arm_world.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "physics/convex_shapes.hpp"
#include "symscene/core/error.hpp"
#include "symscene/physics/physics_world.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

Joint sliding(std::size_t parent, const char* name, const Eigen::Vector3d& axis) {
  Joint joint;
  joint.name = name;
  joint.kind = JointKind::prismatic;
  joint.parent = parent;
  joint.child = parent + 1;
  joint.axis = axis;
  joint.limits = {-1.0, 1.0, 1.0, 5.0};
  joint.position = parent;
  return joint;
}

/// A gantry: it slides along x and z and turns about z. Its tip is a rod that ends where the hand
/// begins.
Robot gantry() {
  Robot robot;
  robot.model.name = "gantry";
  robot.model.links = {{"base", {}}, {"beam", {}}, {"column", {}}, {"tip", {}}};
  robot.model.links[3].capsules.push_back({{0, 0, 0.15}, {0, 0, 0.5}, 0.03});
  robot.model.joints = {sliding(0, "x", Eigen::Vector3d::UnitX()),
                        sliding(1, "z", Eigen::Vector3d::UnitZ()),
                        sliding(2, "turn", Eigen::Vector3d::UnitZ())};
  robot.model.joints[2].kind = JointKind::revolute;
  robot.home = Eigen::Vector3d(0.0, 0.3, 0.0);
  return robot;
}

/// Of a hand that points down, in the gantry's tip.
Eigen::Isometry3d tool_in_tip() {
  return Eigen::Isometry3d(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()));
}

class ArmWorldTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_physics()) GTEST_SKIP() << "skipped: this build has no physics";
  }

  /// A gantry, and a cube at rest on the table.
  ArmWorld world(double mass = 0.2) const {
    const std::vector<WeighedBody> bodies{{&cube_, mass}};
    const Robot robot = gantry();
    ArmWorld world(bodies, robot, Eigen::Isometry3d::Identity(),
                   make_arm(robot.model, "arm", "base", "tip"), tool_in_tip(),
                   panda_parallel_hand());
    world.put(0, at(0, 0, 0.5 * cube_edge));
    world.advance(0.2);
    return world;
  }

  /// Moves at constant speed, as a trajectory would.
  static void move(ArmWorld& world, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                   double seconds) {
    constexpr double step = 0.01;  // [s]
    const int steps = static_cast<int>(seconds / step);
    for (int k = 1; k <= steps; ++k) {
      world.aim_robot(from + (to - from) * k / steps, (to - from) / seconds);
      world.advance(step);
    }
    world.aim_robot(to, Eigen::Vector3d::Zero());
    world.advance(0.2);
  }

  /// Closes the hand around the cube and lifts it.
  static void lift(ArmWorld& world) {
    const Eigen::Vector3d low(0, 0.06, 0), high(0, 0.3, 0);
    move(world, high, low, 0.5);
    world.close_fingers(true);
    world.advance(0.5);
    move(world, low, high, 0.5);
  }

  const ConvexParts cube_ = cube();
};

TEST_F(ArmWorldTest, AHeldArmDoesNotSink) {
  ArmWorld arm = world();
  arm.advance(1.0);
  EXPECT_LT((arm.positions() - gantry().home).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT((arm.hand_pose().translation() - Eigen::Vector3d(0, 0, 0.3)).norm(), 1e-6);
  EXPECT_NEAR(arm.opening(), 0.08, 1e-3);
  EXPECT_FALSE(arm.hand_contacts().any());
  EXPECT_FALSE(arm.arm_contacts().any());
}

TEST_F(ArmWorldTest, JointsReachTheirTargets) {
  ArmWorld arm = world();
  const Eigen::Vector3d target(0.3, 0.4, 1.0);
  move(arm, gantry().home, target, 1.0);
  EXPECT_LT((arm.positions() - target).cwiseAbs().maxCoeff(), 1e-4);
}

TEST_F(ArmWorldTest, ACubeIsLiftedCarriedAndDropped) {
  ArmWorld arm = world();
  lift(arm);
  EXPECT_EQ(arm.hand_contacts().held, std::vector<std::size_t>{0});
  EXPECT_NEAR(arm.opening(), cube_edge, 2e-3);
  EXPECT_NEAR(arm.pose(0).translation().z(), 0.3 - 0.06 + 0.5 * cube_edge, 5e-3);
  move(arm, {0, 0.3, 0}, {0.4, 0.3, 0.5}, 1.0);
  EXPECT_NEAR(arm.pose(0).translation().x(), 0.4, 5e-3);
  arm.close_fingers(false);
  arm.advance(1.0);
  EXPECT_NEAR(arm.pose(0).translation().z(), 0.5 * cube_edge, 5e-3);
  EXPECT_TRUE(arm.hand_contacts().bodies.empty());
}

TEST_F(ArmWorldTest, ALoadBendsTheArmByLessThanAMillimetre) {
  ArmWorld arm = world(0.5);
  lift(arm);
  ASSERT_EQ(arm.hand_contacts().held.size(), 1U);
  EXPECT_LT((arm.positions() - gantry().home).cwiseAbs().maxCoeff(), 1e-3);
}

TEST_F(ArmWorldTest, ALinkThatMeetsABodyIsTold) {
  ArmWorld arm = world();
  arm.put(0, at(0, 0, 0.3 + 0.3));
  EXPECT_EQ(arm.arm_contacts().bodies, std::vector<std::size_t>{0});
  EXPECT_TRUE(arm.hand_contacts().bodies.empty());
}

TEST_F(ArmWorldTest, ALinkThatReachesIntoTheTableDisturbsNothing) {
  Robot robot = gantry();
  robot.model.links[1].capsules.push_back({{0, 0, -0.1}, {0, 0, 0.1}, 0.06});
  const std::vector<WeighedBody> bodies{{&cube_, 0.1}};
  ArmWorld arm(bodies, robot, Eigen::Isometry3d::Identity(),
               make_arm(robot.model, "arm", "base", "tip"), tool_in_tip(), panda_parallel_hand());
  arm.put(0, at(0.3, 0, 0.5 * cube_edge));
  arm.advance(0.5);
  EXPECT_FALSE(arm.arm_contacts().any());
  EXPECT_LT((arm.positions() - robot.home).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT((arm.pose(0).translation() - Eigen::Vector3d(0.3, 0, 0.5 * cube_edge)).norm(), 1e-3);
}

TEST_F(ArmWorldTest, TheSameCallsGiveTheSamePoses) {
  ArmWorld a = world(), b = world();
  lift(a);
  lift(b);
  EXPECT_EQ(a.pose(0).matrix(), b.pose(0).matrix());
  EXPECT_EQ(a.positions(), b.positions());
}

TEST_F(ArmWorldTest, RefusesPositionsOfOtherRobots) {
  ArmWorld arm = world();
  EXPECT_THROW(arm.put_robot(Eigen::VectorXd::Zero(2)), InputError);
  EXPECT_THROW(arm.put_robot(Eigen::Vector3d(0, NAN, 0)), InputError);
}

}  // namespace
}  // namespace symscene
