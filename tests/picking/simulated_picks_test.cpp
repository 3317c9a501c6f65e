#include "symscene/picking/simulated_picks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "symscene/grasping/gripper.hpp"
#include "symscene/io/robot.hpp"
#include "symscene/physics/physics_world.hpp"

#ifdef SYMSCENE_HAS_ROBOTS

namespace symscene {
namespace {

/// Runs with few and small images, to be quick.
class SimulatedPicks : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_physics()) GTEST_SKIP() << "skipped: this build has no physics";
    options_.look.frames = 8;
    options_.look.width = 320;
    options_.look.height = 240;
    options_.look.focal_length = 210.0;
    options_.max_looks = 2;
    table_.tabletop.objects = 1;
    table_.tabletop.seed = 3;
  }

  PickRun run(const Robot& robot, const char* gripper) const {
    return simulate_picks(furnish_pick_table({}, table_), robot, named_gripper(gripper), options_);
  }

  SimulatedPickOptions options_;
  PickTableOptions table_;
};

TEST_F(SimulatedPicks, PutACupIntoTheBin) {
  const PickRun cleared = run(read_robot("panda"), "panda");
  EXPECT_EQ(cleared.end, PickRunEnd::cleared) << description(cleared.end);
  EXPECT_EQ(cleared.all.in_bin, 1U);
  EXPECT_TRUE(cleared.left.empty());
  ASSERT_EQ(cleared.looks.size(), 1U);
  EXPECT_EQ(cleared.looks[0].fused, 8U);
  EXPECT_FALSE(cleared.to_first.empty());
}

TEST_F(SimulatedPicks, ChooseTheirViewsAndEndWhereTheyAreEnough) {
  options_.views = LookViews::next;
  options_.max_looks = 1;
  const PickRun chosen = run(read_robot("panda"), "panda");
  ASSERT_EQ(chosen.looks.size(), 1U);
  const PickLook& few = chosen.looks[0];
  EXPECT_EQ(few.fused, few.frames);
  EXPECT_LE(few.frames, 6U);
  EXPECT_EQ(few.found, 1U);
  EXPECT_EQ(chosen.all.in_bin, 1U);
  options_.next_view.min_share = 1.0;  // nothing is worth a second view
  const PickRun one = run(read_robot("panda"), "panda");
  ASSERT_EQ(one.looks.size(), 1U);
  EXPECT_EQ(one.looks[0].frames, 1U);
  EXPECT_TRUE(one.looks[0].is_enough);
}

TEST_F(SimulatedPicks, ChooseViewsOfACameraThatFlies) {
  options_.views = LookViews::next;
  options_.max_looks = 1;
  Robot robot = read_robot("panda");
  robot.camera.reset();
  const PickRun flown = run(robot, "panda");
  ASSERT_EQ(flown.looks.size(), 1U);
  EXPECT_EQ(flown.looks[0].found, 1U);
}

TEST_F(SimulatedPicks, CorrectThePosesThatTheArmTells) {
  options_.max_looks = 1;
  options_.look.pose_deviation = 0.004;
  const PickRun told = run(read_robot("panda"), "panda");
  ASSERT_EQ(told.looks.size(), 1U);
  EXPECT_GE(told.looks[0].fused, 7U);
  const double by_the_arm = std::sqrt(3.0) * options_.look.pose_deviation;
  EXPECT_LT(told.looks[0].trajectory.absolute, 0.7 * by_the_arm);
}

TEST_F(SimulatedPicks, SayThatTheArmCannotStart) {
  Robot robot = read_robot("panda");
  robot.home[1] = 1.7;  // the shoulder far forward: the hand is in the table
  const PickRun stuck = run(robot, "panda");
  EXPECT_EQ(stuck.end, PickRunEnd::no_start);
  EXPECT_TRUE(stuck.looks.empty());
  ASSERT_EQ(stuck.left.size(), 1U);
  EXPECT_NE(stuck.left[0].reason.find("the arm cannot start: "), std::string::npos)
      << stuck.left[0].reason;
}

TEST_F(SimulatedPicks, SayThatTheRobotBlocksItsCamera) {
  Robot robot = read_robot("panda");
  robot.camera->T_link_camera.translation() << 0.0, 0.0, -0.1;  // behind the palm
  options_.empty_looks = 1;
  const PickRun blind = run(robot, "panda");
  ASSERT_EQ(blind.looks.size(), 1U);
  EXPECT_EQ(blind.looks[0].fused, 0U);
  EXPECT_EQ(blind.end, PickRunEnd::nothing_found);
  ASSERT_EQ(blind.left.size(), 1U);
  EXPECT_NE(blind.left[0].reason.find("blocks the camera"), std::string::npos)
      << blind.left[0].reason;
}

TEST_F(SimulatedPicks, SayThatTheTableIsOutOfReach) {
  Robot robot = read_robot("panda");
  robot.T_world_base.translation() -= Eigen::Vector3d(3.0, 0.0, 0.0);
  const PickRun far = run(robot, "panda");
  EXPECT_EQ(far.end, PickRunEnd::no_view);
  EXPECT_TRUE(far.looks.empty());
  ASSERT_EQ(far.left.size(), 1U);
  EXPECT_FALSE(far.left[0].reason.empty());
}

}  // namespace
}  // namespace symscene

#endif
