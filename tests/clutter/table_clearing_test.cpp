#include "symscene/clutter/table_clearing.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "clutter_scenes.hpp"
#include "symscene/clutter/table_clearing_report.hpp"
#include "symscene/core/error.hpp"
#include "symscene/physics/physics_world.hpp"

namespace symscene {
namespace {

std::vector<ObjectModel> box_models() {
  return {{"tower", box_surface({0.045F, 0.06F, 0.12F}), {}, {}, false},
          {"brick", box_surface({0.05F, 0.09F, 0.06F}), {}, {}, false}};
}

/// Two boxes and few small images.
TableClearingOptions small_options() {
  TableClearingOptions options;
  options.min_objects = options.max_objects = 2;
  options.sweep.drop.upright = 1.0;
  options.sweep.drop.spread = 0.1;
  options.sweep.camera.frames = 4;
  options.sweep.camera.arc = radians(12.0);
  options.sweep.camera.radius = 0.6;
  options.sweep.camera.width = 320;
  options.sweep.camera.height = 240;
  options.sweep.camera.focal_length = 262.5;
  return options;
}

class TableClearingTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_physics()) GTEST_SKIP() << "skipped: this build has no physics";
  }
};

TEST_F(TableClearingTest, TwoBoxesAreFoundInTrackedSweepsAndRemoved) {
  TableClearingOptions options = small_options();
  options.try_each_object = true;
  const TableClearing table = clear_table(box_models(), options, 0);
  ASSERT_EQ(table.placed, 2);
  ASSERT_EQ(table.first_look.size(), 2);
  for (const FirstLookObject& object : table.first_look) {
    EXPECT_TRUE(object.graspable_as_it_lies) << object.name;
    EXPECT_TRUE(object.found) << object.name;
    EXPECT_GT(object.grasps, 0) << object.name << ": " << object.reason;
    EXPECT_EQ(object.end, GraspEnd::success) << object.name;
  }
  EXPECT_EQ(table.end, RoundEnd::cleared);
  EXPECT_EQ(table.removed, 2);
  EXPECT_EQ(table.removed_graspable, 2);
  for (const TableAttempt& attempt : table.attempts) EXPECT_EQ(attempt.fused, attempt.frames);
  const TableFigures figures = table_figures(std::vector{table});
  EXPECT_EQ(figures.removed.part, 2);
  EXPECT_EQ(figures.success.whole, table.attempts.size());
}

TEST_F(TableClearingTest, ATableSettlesWhereItWasDroppedAndLosesWhatIsTakenAway) {
  const TableClearingOptions options = small_options();
  TabletopOptions tabletop_options = options.sweep.tabletop;
  tabletop_options.objects = 2;
  const Tabletop tabletop = drop_tabletop(box_models(), tabletop_options, options.sweep.drop);
  TableWorld world(tabletop, options.sweep.drop);
  ASSERT_EQ(world.present().size(), 2);
  for (std::size_t i = 0; i < 2; ++i) {
    const Eigen::Vector3d moved = world.tabletop().objects[i].T_world_object.translation() -
                                  tabletop.objects[i].T_world_object.translation();
    EXPECT_LT(moved.norm(), 0.002);
  }
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();  // from above, across the tower
  const Eigen::Isometry3d tower = tabletop.objects[0].T_world_object;
  T_world_tool.linear() << tower.linear().col(1), tower.linear().col(0), -Eigen::Vector3d::UnitZ();
  T_world_tool.translation() = tower.translation() + Eigen::Vector3d(0, 0, 0.085);
  ASSERT_EQ(world.model(0).name, "tower");
  EXPECT_EQ(world.rehearse(T_world_tool).end, GraspEnd::success);
  ASSERT_EQ(world.present().size(), 2);
  EXPECT_TRUE(world.tabletop().objects[0].T_world_object.isApprox(tower, 0.01));
  EXPECT_EQ(world.execute(T_world_tool).end, GraspEnd::success);
  ASSERT_EQ(world.tabletop().objects.size(), 1);
  EXPECT_EQ(world.tabletop().objects.front().object.name, "brick");
}

TEST(TableClearingOptionsTest, AMethodOnTrueMeshesIsRefused) {
  TableClearingOptions options;
  options.method = GraspMethod::true_meshes;
  EXPECT_THROW(options.validate(), InputError);
}

/// A table with these numbers of successful attempts, attempts, removed and placed objects.
TableClearing table_with(int successes, int attempts, int removed, int placed) {
  TableClearing table;
  table.removed = removed;
  table.placed = placed;
  table.end = RoundEnd::no_grasp;
  for (int k = 0; k < placed; ++k) {
    FirstLookObject object;
    object.name = "box";
    object.graspable = k % 2 == 0;
    object.grasps = k == 0 ? 3 : 0;
    object.reason = k == 0 ? "" : "too far";
    table.first_look.push_back(object);
  }
  for (int k = 0; k < attempts; ++k) {
    TableAttempt attempt;
    attempt.number = k + 1;
    attempt.tried = true;
    attempt.outcome.end = k < successes ? GraspEnd::success : GraspEnd::slipped;
    table.attempts.push_back(attempt);
  }
  return table;
}

TEST(TableReportTest, SharesAreOfAllTablesTogether) {
  const std::vector<TableClearing> tables{table_with(3, 3, 3, 4), table_with(0, 2, 0, 2)};
  const TableFigures figures = table_figures(tables);
  EXPECT_DOUBLE_EQ(figures.success.value, 3.0 / 5.0);
  EXPECT_DOUBLE_EQ(figures.first_success.value, 1.0 / 2.0);
  EXPECT_DOUBLE_EQ(figures.removed.value, 3.0 / 6.0);
  EXPECT_DOUBLE_EQ(figures.with_grasp.value, 2.0 / 6.0);
  EXPECT_DOUBLE_EQ(figures.graspable_with_grasp.value, 2.0 / 3.0);
  EXPECT_EQ(figures.cleared.part, 0);
  EXPECT_EQ(figures.cleared.whole, 2);
  EXPECT_LE(figures.success.low, figures.success.value);
  EXPECT_GE(figures.success.high, figures.success.value);
}

TEST(TableReportTest, AStoppedTableCountsForItsLooksOnly) {
  std::vector<TableClearing> tables{table_with(3, 3, 3, 4), table_with(0, 2, 0, 2)};
  tables[1].stopped = true;
  const TableFigures figures = table_figures(tables);
  EXPECT_EQ(figures.removed.whole, 4);
  EXPECT_EQ(figures.graspable_removed.whole, 2);
  EXPECT_EQ(figures.cleared.whole, 1);
  EXPECT_EQ(figures.success.whole, 5);
  EXPECT_EQ(figures.with_grasp.whole, 6);
}

TEST(TableReportTest, FilesHaveOneLinePerLookAndPerObject) {
  const std::vector<TableClearing> tables{table_with(3, 3, 3, 4), table_with(0, 2, 0, 2)};
  const auto lines = [](const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
  };
  const auto columns = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  const std::string looks = format_looks_csv(tables);
  EXPECT_EQ(lines(looks), 1 + 5);
  EXPECT_EQ(columns(looks), 6 * columns(looks.substr(0, looks.find('\n'))));
  EXPECT_EQ(lines(format_first_looks_csv(tables)), 1 + 6);
}

}  // namespace
}  // namespace symscene
