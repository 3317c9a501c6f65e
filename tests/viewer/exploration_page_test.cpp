#include "symscene/viewer/exploration_page.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "explored_box.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

TEST(ExplorationPage, HoldsEachViewWithWhatIsKnownAfterIt) {
  const std::string page = render_exploration_page(explored_box(), "One box");
  EXPECT_NE(page.find(R"("completed":0.5,"depth":{"data":"AAGA/w==","height":2,"width":2})"),
            std::string::npos);
  EXPECT_NE(page.find(R"("completed":0.875)"), std::string::npos);
  EXPECT_NE(page.find(R"("end":"all candidate views were taken")"), std::string::npos);
  EXPECT_EQ(page.find("@@SYMSCENE"), std::string::npos);
}

TEST(ExplorationPage, RefusesWhatCannotBeDrawn) {
  const auto expect_refusal = [](auto&& change) {
    ExplorationRecording exploration = explored_box();
    change(exploration);
    EXPECT_THROW(render_exploration_page(exploration, ""), InputError);
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refusal([](auto& e) { e.views.clear(); });
  expect_refusal([](auto& e) { e.views[0].time = 3.0; });
  expect_refusal([](auto& e) { e.views[1].observed = nan; });
  expect_refusal([](auto& e) { e.views[1].view.gain = nan; });
  expect_refusal([](auto& e) { e.views[0].next.views[0].T_world_camera.translation().x() = nan; });
  expect_refusal([](auto& e) { e.views[0].depth.nearness.pop_back(); });
  expect_refusal([](auto& e) { e.run.poses.pop_back(); });
}

}  // namespace
}  // namespace symscene
