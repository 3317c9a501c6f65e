#include "symscene/exploration/exploration.hpp"

#include <gtest/gtest.h>

#include "clutter/clutter_scenes.hpp"
#include "symscene/core/error.hpp"
#include "symscene/exploration/exploration_report.hpp"
#include "symscene/physics/physics_world.hpp"

namespace symscene {
namespace {

class ExploreClutter : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_physics()) GTEST_SKIP() << "skipped: this build has no physics";
  }
  std::vector<Exploration> explore(std::vector<ExplorationPolicy> policies, int views) const {
    ExplorationOptions options;
    options.objects = 2;
    options.views = views;
    options.grasp_after = 2;
    options.seed = 3;
    return explore_clutter(objects_, policies, options, 1);
  }
  const std::vector<ClutterObject> objects_ = box_objects();
};

TEST_F(ExploreClutter, PoliciesShareTheFirstViewAndVisitNoneTwice) {
  const auto explorations = explore({ExplorationPolicy::symmetry, ExplorationPolicy::fixed_arc}, 3);
  ASSERT_EQ(explorations.size(), 2U);
  EXPECT_EQ(explorations[0].steps[0].observed, explorations[1].steps[0].observed);
  for (const Exploration& e : explorations) {
    ASSERT_EQ(e.steps.size(), 3U);
    EXPECT_NE(e.steps[0].view, e.steps[1].view);
    EXPECT_NE(e.steps[1].view, e.steps[2].view);
    EXPECT_NE(e.steps[0].view, e.steps[2].view);
    EXPECT_TRUE(e.steps[1].grasped.has_value());
    EXPECT_FALSE(e.steps[0].grasped || e.steps[2].grasped);
  }
}

TEST_F(ExploreClutter, ThreeViewsShowMoreThanOneCompletionAddsAndSymmetriesAreCounted) {
  const Exploration e = explore({ExplorationPolicy::oracle}, 3).front();
  EXPECT_GT(e.steps[2].observed, e.steps[0].observed);
  EXPECT_EQ(e.kind, "packed");
  for (const ExplorationStep& step : e.steps) {
    EXPECT_GE(step.completed, step.observed);
    EXPECT_EQ(step.axes.ground_truth, 0U);    // of boxes
    EXPECT_GE(step.planes.ground_truth, 6U);  // of two boxes; more of square ones
    EXPECT_LE(step.planes.correct, std::min(step.planes.found, step.planes.ground_truth));
  }
  EXPECT_GT(e.steps.back().planes.correct, 0U);
}

std::vector<ObjectModel> box_models() {
  std::vector<ObjectModel> models;
  for (const ClutterObject& box : box_objects()) {
    models.push_back({box.name, box.surface, {}, {}, false});
  }
  return models;
}

TEST_F(ExploreClutter, TablesOfScannedObjectsAreExploredInTheSameWay) {
  ExplorationOptions options;
  options.objects = 2;
  options.views = 2;
  options.grasp_after = 1;
  const std::vector policies{ExplorationPolicy::symmetry, ExplorationPolicy::fixed_arc};
  const auto explorations = explore_scanned_table(box_models(), policies, options, 4);
  ASSERT_EQ(explorations.size(), 2U);
  EXPECT_EQ(explorations[0].steps[0].observed, explorations[1].steps[0].observed);
  for (const Exploration& e : explorations) {
    EXPECT_EQ(e.kind, scanned_table_kind);
    EXPECT_EQ(e.scene, 4);
    ASSERT_EQ(e.steps.size(), 2U);
    EXPECT_TRUE(e.steps[0].grasped.has_value());
    EXPECT_GT(e.steps[0].observed, 0.1);
    EXPECT_EQ(e.steps[0].masks.ground_truth, 2U);
    EXPECT_GE(e.steps[0].planes.ground_truth, 6U);
  }
}

TEST_F(ExploreClutter, IsTheSameAgain) {
  const auto csv = [&] {
    auto explorations = explore({ExplorationPolicy::unknown_voxels, ExplorationPolicy::random}, 2);
    for (Exploration& e : explorations) {
      for (ExplorationStep& step : e.steps) step.decision_seconds = 0.0;
    }
    return format_explorations_csv(explorations);
  };
  EXPECT_EQ(csv(), csv());
}

TEST(ExplorationPolicies, AreReadByTheNamesThatTheyAreWrittenWith) {
  for (const ExplorationPolicy policy : exploration_policies())
    EXPECT_EQ(parse_exploration_policy(to_string(policy)), policy);
  EXPECT_THROW(parse_exploration_policy("nearest"), InputError);
}

TEST(ExplorationOptions, RefuseNoViewsAndNoRadius) {
  ExplorationOptions options;
  options.views = 0;
  EXPECT_THROW(options.validate(), InputError);
  options.views = 1;
  options.radius = 0.0;
  EXPECT_THROW(options.validate(), InputError);
}

}  // namespace
}  // namespace symscene
