#include "symscene/exploration/table_exploration.hpp"

#include <gtest/gtest.h>

#include <set>

#include "symscene/core/error.hpp"
#include "symscene/exploration/exploration_output.hpp"
#include "symscene/physics/physics_world.hpp"

namespace symscene {
namespace {

TableExplorationOptions small_options(ExplorationPolicy policy = ExplorationPolicy::symmetry) {
  TableExplorationOptions options;
  options.policy = policy;
  options.objects = 2;
  options.views = 2;
  options.choice.min_share = 0.0;  // never enough
  return options;
}

TableExploration explored(const TableExplorationOptions& options) {
  return explore_table(furnish_exploration({}, options), options);
}

/// What does not depend on times.
std::string lasting(const TableExploration& exploration, const Tabletop& table) {
  TableExploration timeless = exploration;
  for (ExploredView& view : timeless.views) view.timings.clear();
  return format_exploration_json(timeless, table, "{}");
}

TEST(ExploreTable, TakesEachViewForTheGainThatThePolicyExpectedOfIt) {
  const TableExploration exploration = explored(small_options());
  ASSERT_EQ(exploration.views.size(), 2U);
  EXPECT_EQ(exploration.end, ExplorationEnd::views);
  const ExploredView &first = exploration.views[0], &second = exploration.views[1];
  EXPECT_FALSE(first.step.gain);
  const RankedView& best = first.next.ranked.front();
  EXPECT_EQ(second.step.view, best.candidate);
  ASSERT_TRUE(second.step.gain);
  EXPECT_EQ(second.step.gain->total(), best.gain.total());
  EXPECT_TRUE(second.T_world_camera.isApprox(exploration.candidates[second.step.view]));
  EXPECT_GT(second.step.observed, first.step.observed);
}

TEST(ExploreTable, RanksNoViewThatWasTaken) {
  const TableExploration exploration = explored(small_options());
  std::set<std::size_t> taken;
  for (const ExploredView& view : exploration.views) {
    taken.insert(view.step.view);
    EXPECT_EQ(view.next.ranked.size(), exploration.candidates.size() - taken.size());
    for (const RankedView& ranked : view.next.ranked) EXPECT_EQ(taken.count(ranked.candidate), 0U);
  }
}

TEST(ExploreTable, EndsWhereNoViewIsExpectedToShowMuch) {
  for (const auto policy : {ExplorationPolicy::symmetry, ExplorationPolicy::random}) {
    TableExplorationOptions options = small_options(policy);
    options.choice.min_share = 1.0;
    const TableExploration exploration = explored(options);
    EXPECT_EQ(exploration.views.size(), 1U) << to_string(policy);
    EXPECT_EQ(exploration.end, ExplorationEnd::enough) << to_string(policy);
  }
}

TEST(ExploreTable, TellsWhatIsLeftUnknown) {
  const TableExplorationOptions options = small_options(ExplorationPolicy::fixed_arc);
  const Tabletop table = furnish_exploration({}, options);
  const TableExploration exploration = explore_table(table, options);
  const NextViews& left = exploration.left();
  double inferred = 0.0, all = 0.0;
  for (const ObjectArea& area : left.areas) {
    EXPECT_LE(area.inferred, area.all);
    inferred += area.inferred;
    all += area.all;
  }
  EXPECT_EQ(left.areas.size(), exploration.result.objects.size());
  EXPECT_DOUBLE_EQ(inferred, left.inferred_area);
  EXPECT_DOUBLE_EQ(all, left.object_area);
  EXPECT_EQ(exploration.seen.size(), table.objects.size());
  EXPECT_GE(format_left_unknown(exploration, table).size(), 3U);
}

TEST(ExploreTable, IsTheSameAgainAndOtherWithAnotherSeed) {
  TableExplorationOptions options = small_options(ExplorationPolicy::random);
  const Tabletop table = furnish_exploration({}, options);
  const std::string once = lasting(explore_table(table, options), table);
  EXPECT_EQ(once, lasting(explore_table(table, options), table));
  options.seed = 2;
  EXPECT_NE(once, lasting(explore_table(table, options), table));
}

TEST(ExploreTable, TellsItsObserverOfEveryViewAndStage) {
  TableExplorationOptions options = small_options(ExplorationPolicy::fixed_arc);
  std::vector<std::string> told;
  const ExplorationObserver observer{
      [&](const std::string& stage) { told.push_back(stage); },
      [&](const ExploredView& view) { told.push_back(std::to_string(view.step.view)); }};
  const auto exploration = explore_table(furnish_exploration({}, options), options, observer);
  EXPECT_EQ(told.front(), "view 1: look");
  EXPECT_NE(std::find(told.begin(), told.end(), "view 2: choose"), told.end());
  EXPECT_EQ(told.back(), std::to_string(exploration.views.back().step.view));
}

TEST(ExplorationRecording, MovesTheCameraFromViewToView) {
  const TableExplorationOptions options = small_options();
  const Tabletop table = furnish_exploration({}, options);
  const TableExploration exploration = explore_table(table, options);
  const ExplorationRecording recording = exploration_recording(exploration, table);
  ASSERT_EQ(recording.views.size(), exploration.views.size());
  for (std::size_t k = 0; k < recording.views.size(); ++k) {
    const auto moment =
        std::find(recording.run.times.begin(), recording.run.times.end(), recording.views[k].time) -
        recording.run.times.begin();
    const Eigen::Isometry3d& camera =
        recording.run.poses.at(static_cast<std::size_t>(moment)).back();
    EXPECT_TRUE((table.T_world_table * camera).isApprox(exploration.views[k].T_world_camera));
    EXPECT_EQ(recording.run.beliefs[k].objects.size(), exploration.views[k].objects.size());
  }
  EXPECT_NE(render_exploration_page(recording, "Boxes").find("\"exploration\":{"),
            std::string::npos);
}

TEST(FurnishExploration, PutsObjectsOnTheTableOfTheBenchmark) {
  const Tabletop table = furnish_exploration({}, small_options());
  EXPECT_EQ(table.objects.size(), 2U);
  for (const PlacedObject& placed : table.objects) {
    const float lowest = world_mesh(placed).vertices.col(2).minCoeff();
    EXPECT_NEAR(lowest, clutter::table_height, 2e-3);
  }
}

TEST(FurnishExploration, NeedsPhysicsForPilesAndMeshes) {
  TableExplorationOptions options = small_options();
  EXPECT_FALSE(needs_physics(options, false));
  EXPECT_TRUE(needs_physics(options, true));
  options.kind = ClutterKind::pile;
  EXPECT_TRUE(needs_physics(options, false));
  if (!has_physics()) return;
  EXPECT_FALSE(furnish_exploration({}, options).objects.empty());
}

TEST(ExplorationPolicies, RankByThePolicyOfTheSameName) {
  for (const ExplorationPolicy policy : exploration_policies()) {
    if (const auto ranking = ranking_policy(policy)) {
      EXPECT_STREQ(to_string(*ranking), to_string(policy));
    }
  }
  EXPECT_FALSE(ranking_policy(ExplorationPolicy::random));
}

}  // namespace
}  // namespace symscene
