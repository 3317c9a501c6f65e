#include "symscene/viewer/plan_page.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "planned_run.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

TEST(PlanPage, HoldsEveryGraspWithItsReason) {
  const std::string page = render_plan_page(planned_box(), "A plan");
  EXPECT_NE(page.find(R"("reason":"a joint would leave its limits","state":"not_reached")"),
            std::string::npos);
  for (const char* state : {"chosen", "reached", "not_tried"})
    EXPECT_NE(page.find("\"state\":\"" + std::string(state) + '"'), std::string::npos) << state;
  EXPECT_EQ(page.find("@@SYMSCENE"), std::string::npos);
}

TEST(PlanPage, HoldsSharesAsBytes) {
  PlanRecording plan = planned_box();
  plan.reach->from_above = {0.0F, 0.0F, 1.0F, 1.0F, 1.0F, 0.0F};
  const std::string page = render_plan_page(plan, "A plan");
  EXPECT_NE(page.find(R"("above":"AAD///8A")"), std::string::npos);
  EXPECT_NE(page.find(R"("side":"AAAAAAAA")"), std::string::npos);
}

TEST(PlanPage, NeedsNoMapAndNoGrasps) {
  PlanRecording plan = planned_box();
  plan.reach.reset();
  plan.grasps.clear();
  const std::string page = render_plan_page(plan, "A plan");
  EXPECT_NE(page.find(R"("reach":null)"), std::string::npos);
}

TEST(PlanPage, RefusesWhatCannotBeDrawn) {
  PlanRecording shares = planned_box();
  shares.reach->from_side.pop_back();
  EXPECT_THROW(render_plan_page(shares, ""), InputError);
  PlanRecording pose = planned_box();
  pose.grasps[0].grasp.T_world_tool.translation().x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(render_plan_page(pose, ""), InputError);
  PlanRecording cell = planned_box();
  cell.reach->centers(0, 0) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(render_plan_page(cell, ""), InputError);
  PlanRecording motion = planned_box();
  motion.motion.poses.pop_back();
  EXPECT_THROW(render_plan_page(motion, ""), InputError);
}

}  // namespace
}  // namespace symscene
