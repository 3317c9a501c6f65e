#include "symscene/grasping/gripper.hpp"

#include <gtest/gtest.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

TEST(Gripper, IsValidForEveryName) {
  for (const std::string_view name : gripper_names()) {
    const Gripper gripper = named_gripper(name);
    EXPECT_EQ(gripper.name, name);
    EXPECT_NO_THROW(gripper.validate());
  }
}

TEST(Gripper, HasTheMeasuresOfThePandaHand) {
  const Gripper gripper = panda_hand();
  EXPECT_EQ(gripper.max_opening, 0.08);
  EXPECT_EQ(gripper.finger_depth, 0.05);
  EXPECT_EQ(gripper.T_wrist_tool.translation(), Eigen::Vector3d(0.0, 0.0, 0.062));
  EXPECT_EQ(gripper.force, 20.0);
}

TEST(Gripper, OfBaxterHasAStrokeOf42Millimetres) {
  const Gripper gripper = baxter_electric_gripper();
  EXPECT_NEAR(gripper.max_opening - gripper.min_opening, 0.0417, 1e-9);
}

TEST(Gripper, RefusesAnUnknownName) { EXPECT_THROW(named_gripper("claw"), InputError); }

TEST(Gripper, RefusesContradictions) {
  const auto refuses = [](const auto& change) {
    Gripper gripper = reflex_gripper();
    change(gripper);
    EXPECT_THROW(gripper.validate(), InputError);
  };
  refuses([](Gripper& gripper) { gripper.min_opening = gripper.max_opening; });
  refuses([](Gripper& gripper) { gripper.tip_thickness = 2.0 * gripper.finger_thickness; });
  refuses([](Gripper& gripper) { gripper.finger_spacing = 0.0; });
  refuses([](Gripper& gripper) { gripper.kind = GripperKind::parallel; });
  refuses([](Gripper& gripper) { gripper.palm_size.x() = -0.1; });
  refuses([](Gripper& gripper) { gripper.friction = 0.0; });
}

}  // namespace
}  // namespace symscene
