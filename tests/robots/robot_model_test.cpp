#include "symscene/robots/robot_model.hpp"

#include <gtest/gtest.h>

#include "small_robots.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

TEST(RobotModel, PlacesLinksBehindTheirJoints) {
  const RobotModel model = planar_arm();
  ASSERT_NO_THROW(model.validate());
  const auto poses = link_poses(model, Eigen::Vector2d(radians(90.0), radians(-90.0)));
  EXPECT_TRUE(poses[2].translation().isApprox(Eigen::Vector3d(0.0, 0.3, 0.0), 1e-12));
  EXPECT_TRUE(poses[3].translation().isApprox(Eigen::Vector3d(0.2, 0.3, 0.0), 1e-12));
}

TEST(RobotModel, SlidesAPrismaticJointAlongItsAxis) {
  RobotModel model = single_link();
  Eigen::Isometry3d turned(Eigen::AngleAxisd(radians(90.0), Eigen::Vector3d::UnitZ()));
  add_link(model, 0, turned, Eigen::Vector3d::UnitX(), JointKind::prismatic);
  const auto poses = link_poses(model, Eigen::VectorXd::Constant(1, 0.4));
  EXPECT_TRUE(poses[1].translation().isApprox(Eigen::Vector3d(0.0, 0.4, 0.0), 1e-12));
}

TEST(RobotModel, RefusesPositionsOfAnotherNumberOrNotFinite) {
  EXPECT_THROW(link_poses(planar_arm(), Eigen::VectorXd::Zero(3)), InputError);
  EXPECT_THROW(link_poses(planar_arm(), Eigen::Vector2d(0.0, NAN)), InputError);
}

TEST(RobotModel, NamesTheNearestLink) {
  try {
    planar_arm().link_index("lnk2");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.found(), "\"lnk2\" (did you mean \"link2\"?)");
  }
}

TEST(RobotModel, RefusesContradictions) {
  const auto refuses = [](const auto& change) {
    RobotModel model = planar_arm();
    change(model);
    EXPECT_THROW(model.validate(), InputError);
  };
  refuses([](RobotModel& model) { model.joints.pop_back(); });
  refuses([](RobotModel& model) { model.joints[1].parent = 2; });
  refuses([](RobotModel& model) { model.joints[1].axis *= 2.0; });
  refuses([](RobotModel& model) { model.joints[1].limits.lower = 4.0; });
  refuses([](RobotModel& model) { model.joints[1].limits.velocity = 0.0; });
  refuses([](RobotModel& model) { model.joints[1].T_parent_joint.translation().x() = NAN; });
  refuses([](RobotModel& model) { model.joints[1].name = model.joints[0].name; });
  refuses([](RobotModel& model) { model.links[1].capsules.emplace_back(); });
  refuses([](RobotModel& model) { model.ignored_pairs = {{2, 1}}; });
}

TEST(RobotModel, MakesAnArmOfTheJointsBetweenTwoLinks) {
  const RobotModel model = planar_arm();
  const Arm arm = make_arm(model, "arm", "link1", "link3");
  EXPECT_EQ(arm.joints, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(arm.positions, std::vector<std::size_t>{1});
  EXPECT_TRUE(make_arm(model, "none", "link1", "link1").joints.empty());
  EXPECT_THROW(make_arm(model, "arm", "link3", "link1"), InputError);
}

TEST(RobotModel, ReplacesThePositionsOfAnArmOnly) {
  const Arm arm = make_arm(planar_arm(), "arm", "link1", "link3");
  const Eigen::VectorXd all =
      with_arm_positions(arm, Eigen::VectorXd::Constant(1, 7.0), Eigen::Vector2d(1.0, 2.0));
  EXPECT_EQ(all, Eigen::Vector2d(1.0, 7.0));
  EXPECT_EQ(arm_positions(arm, all), Eigen::VectorXd::Constant(1, 7.0));
}

TEST(RobotModel, TestsBodiesThatNoJointConnectsForCollision) {
  RobotModel model = planar_arm();
  for (Link& link : model.links)
    link.capsules.push_back({Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), 0.1});
  // Links 2 and 3 are one body; 0 and 1, and 1 and 2, are connected by a joint.
  const std::vector<std::pair<std::size_t, std::size_t>> pairs{{0, 2}, {0, 3}};
  EXPECT_EQ(self_collision_pairs(model), pairs);
  model.ignored_pairs = {{0, 3}};
  EXPECT_TRUE(ignores_collision(model, 3, 0));
  EXPECT_FALSE(ignores_collision(model, 2, 0));
  model.links[2].capsules.clear();
  EXPECT_TRUE(self_collision_pairs(model).empty());
}

}  // namespace
}  // namespace symscene
