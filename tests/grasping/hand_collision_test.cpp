#include "grasping/hand_collision.hpp"

#include <gtest/gtest.h>

#include <random>

#include "grasp_scenes.hpp"

namespace symscene {
namespace {

TEST(HandShape, FillsTheFingersFromThePalmToTheTips) {
  const Gripper gripper = panda_hand();
  const HandShape shape = hand_shape(gripper, 0.08, 0.0);
  const auto distance = [&](double x, double y, double z) {
    float least = 1.0F;
    for (const HandBox& box : shape.fingers())
      least = std::min(least, box.distance(Eigen::Vector3d(x, y, z).cast<float>()));
    return least;
  };
  EXPECT_LT(distance(0.0, 0.045, 0.049), 0.0F);
  EXPECT_LT(distance(0.0, -0.045, 0.001), 0.0F);
  EXPECT_NEAR(distance(0.0, 0.0, 0.02), 0.04, 1e-6);
  EXPECT_NEAR(distance(0.0, 0.045, 0.06), 0.01, 1e-6);
}

TEST(HandShape, HasTwoFingersAgainstOneOfThree) {
  const Gripper gripper = reflex_gripper();
  const HandShape shape = hand_shape(gripper, 0.1, 0.0);
  ASSERT_EQ(shape.fingers().size(), 6);
  const auto positive = std::count_if(shape.fingers().begin(), shape.fingers().end(),
                                      [](const HandBox& box) { return box.centre.y() > 0.0F; });
  EXPECT_EQ(positive, 4);
}

Eigen::Isometry3f random_motion(std::mt19937& random) {
  std::uniform_real_distribution<float> any(-0.1F, 0.1F);
  const Eigen::Vector3f axis(any(random), any(random), 0.2F);
  return Eigen::Translation3f(any(random), any(random), any(random)) *
         Eigen::AngleAxisf(30.0F * any(random), axis.normalized());
}

float brute_force_distance(const SurfaceSamples& samples, const Eigen::Isometry3f& T_tool_world,
                           const std::vector<HandBox>& boxes, float irrelevant) {
  float least = irrelevant;
  for (Eigen::Index i = 0; i < samples.size(); ++i) {
    const Eigen::Vector3f p = T_tool_world * Eigen::Vector3f(samples.positions.row(i).transpose());
    for (const HandBox& box : boxes) least = std::min(least, box.distance(p));
  }
  return least;
}

TEST(LeastDistance, EqualsThatOfAllPoints) {
  const std::vector<HandBox> boxes = hand_shape(panda_hand(), 0.08, 0.05).boxes;
  std::mt19937 random(3);
  // The larger one has more blocks than an array of coordinates holds.
  for (const GraspObject& object :
       {testing::cylinder_at(0.04, 0.1, 0, 0), testing::box_at({0.3, 0.3, 0.1}, 0.0, 0.0)}) {
    const SurfaceSamples samples = surface_samples(object.surface);
    for (int trial = 0; trial < 50; ++trial) {
      const Eigen::Isometry3f T_tool_world = random_motion(random);
      EXPECT_EQ(least_distance(samples, T_tool_world, boxes, {0.02F, -1.0F}),
                brute_force_distance(samples, T_tool_world, boxes, 0.02F));
    }
  }
}

TEST(LeastDistance, EndsBelowABoundIfAnyPointIsBelowIt) {
  const std::vector<HandBox> boxes = hand_shape(panda_hand(), 0.08, 0.05).boxes;
  const SurfaceSamples samples = surface_samples(testing::cylinder_at(0.04, 0.1, 0, 0).surface);
  std::mt19937 random(4);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Isometry3f T_tool_world = random_motion(random);
    const float least = brute_force_distance(samples, T_tool_world, boxes, 0.02F);
    EXPECT_EQ(least_distance(samples, T_tool_world, boxes, {0.02F, 0.002F}) < 0.002F,
              least < 0.002F);
  }
}

TEST(HeightOver, IsThatOfTheLowestCorner) {
  const std::vector<HandBox> boxes{HandBox::between({-0.1, -0.2, 0.0}, {0.1, 0.2, 0.3})};
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() =
      Eigen::AngleAxisd(0.5, Eigen::Vector3d(1.0, -1.0, 0.3).normalized()).toRotationMatrix();
  pose.translation().z() = 0.7;
  double lowest = 1.0;
  for (const double x : {-0.1, 0.1}) {
    for (const double y : {-0.2, 0.2}) {
      for (const double z : {0.0, 0.3})
        lowest = std::min(lowest, (pose * Eigen::Vector3d(x, y, z)).z());
    }
  }
  EXPECT_NEAR(height_over(Plane{}, pose, boxes), lowest, 1e-7);
}

}  // namespace
}  // namespace symscene
