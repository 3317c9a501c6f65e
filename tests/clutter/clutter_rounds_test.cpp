#include "symscene/clutter/clutter_rounds.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "clutter/method_parts.hpp"
#include "clutter_scenes.hpp"
#include "core/random.hpp"
#include "symscene/clutter/clutter_gallery.hpp"
#include "symscene/clutter/clutter_report.hpp"
#include "symscene/core/error.hpp"
#include "symscene/grasping/gripper.hpp"
#include "symscene/physics/physics_world.hpp"

namespace symscene {
namespace {

class ClutterRoundTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_physics()) GTEST_SKIP() << "skipped: this build has no physics";
  }
  ClutterRound play(GraspMethod method, int objects = 2) const {
    ClutterRoundOptions options;
    options.kind = ClutterKind::packed;
    options.objects = objects;
    options.method = method;
    options.seed = 5;
    return run_clutter_round(objects_, options, 3);
  }
  const std::vector<ClutterObject> objects_ = box_objects();
};

TEST_F(ClutterRoundTest, ThePlannerClearsTwoTrueBoxes) {
  const ClutterRound round = play(GraspMethod::true_meshes);
  EXPECT_EQ(round.end, RoundEnd::cleared);
  EXPECT_EQ(round.removed, round.placed);
  EXPECT_TRUE(round.left_objects.empty());
}

TEST_F(ClutterRoundTest, ABoxThatACameraSeesIsRemoved) {
  const ClutterRound round = play(GraspMethod::symscene, 1);
  ASSERT_FALSE(round.attempts.empty());
  EXPECT_EQ(round.removed, 1) << to_string(round.end) << ", "
                              << to_string(round.attempts.front().outcome.end);
  EXPECT_LT(round.attempts.front().aimed_distance, 0.05);
  EXPECT_EQ(round.attempts.front().seen, 1);
}

TEST_F(ClutterRoundTest, TwoFailuresInARowEndTheRound) {
  const ClutterRound round = play(GraspMethod::random, 3);
  ASSERT_EQ(round.end, RoundEnd::failures);
  ASSERT_GE(round.attempts.size(), 2);
  const auto last = round.attempts.end() - 2;
  EXPECT_NE(last[0].outcome.end, GraspEnd::success);
  EXPECT_NE(last[1].outcome.end, GraspEnd::success);
  EXPECT_EQ(round.left, static_cast<int>(round.left_objects.size()));
}

TEST_F(ClutterRoundTest, AnAttemptInWhichThePhysicsDivergesHasFailed) {
  ClutterRoundOptions options;
  options.kind = ClutterKind::packed;
  options.objects = 2;
  options.method = GraspMethod::true_meshes;
  options.seed = 5;
  options.physics.hand_stiffness = 1e13;  // unstable at this time step
  options.physics.hand_force = 1e13;
  const ClutterRound round = run_clutter_round(objects_, options, 3);
  EXPECT_EQ(round.end, RoundEnd::diverged);
  ASSERT_EQ(round.attempts.size(), 1);
  EXPECT_EQ(round.attempts.front().outcome.end, GraspEnd::diverged);
  EXPECT_EQ(round.attempts.front().round, 3);
  EXPECT_EQ(round.left, round.placed);
  const RoundShare success = grasp_success_rate(std::vector{round});
  EXPECT_EQ(success.part, 0);
  EXPECT_EQ(success.whole, 1);
}

TEST_F(ClutterRoundTest, TheSameOptionsGiveTheSameAttempts) {
  const ClutterRound a = play(GraspMethod::antipodal, 3), b = play(GraspMethod::antipodal, 3);
  ASSERT_EQ(a.attempts.size(), b.attempts.size());
  for (std::size_t i = 0; i < a.attempts.size(); ++i) {
    EXPECT_EQ(a.attempts[i].outcome.width, b.attempts[i].outcome.width);
    EXPECT_TRUE(a.attempts[i].grasp.T_world_tool.isApprox(b.attempts[i].grasp.T_world_tool, 0.0));
  }
}

TEST_F(ClutterRoundTest, RehearsalsAreUndone) {
  ClutterRoundOptions options;
  options.kind = ClutterKind::packed;
  options.objects = 2;
  options.method = GraspMethod::true_meshes;
  options.seed = 5;
  options.rehearsals = 3;
  const ClutterRound rehearsed = run_clutter_round(objects_, options, 3);
  const ClutterRound plain = play(GraspMethod::true_meshes);
  EXPECT_EQ(rehearsed.rehearsals.size(), 3 * rehearsed.attempts.size());
  EXPECT_TRUE(plain.rehearsals.empty());
  EXPECT_EQ(rehearsed.removed, plain.removed);
  ASSERT_FALSE(plain.attempts.empty());
  EXPECT_TRUE(rehearsed.attempts.front().grasp.T_world_tool.isApprox(
      plain.attempts.front().grasp.T_world_tool, 0.0));
}

TEST_F(ClutterRoundTest, TheBestGraspOfEachObjectIsTriedAndUndone) {
  ClutterRoundOptions options;
  options.kind = ClutterKind::packed;
  options.objects = 2;
  options.method = GraspMethod::true_meshes;
  options.seed = 5;
  options.rehearse_best = true;
  const ClutterRound round = run_clutter_round(objects_, options, 3);
  ASSERT_EQ(round.placed_objects.size(), 2);
  ASSERT_EQ(round.end, RoundEnd::cleared);
  EXPECT_EQ(round.trials.size(), 3) << "two objects, then one";
  for (const ObjectTrial& trial : round.trials) EXPECT_EQ(trial.succeeded, true);
  EXPECT_EQ(round.rehearsals.size(), round.trials.size());
  EXPECT_NE(round.rehearsals[0].grasp.object, round.rehearsals[1].grasp.object);
  for (const PlacedItem& object : round.placed_objects) EXPECT_TRUE(object.removed);
}

TEST_F(ClutterRoundTest, AntipodalGraspsHaveTheirContactsOnOppositeSides) {
  const ClutterWorld world(objects_, ClutterKind::packed, 3, 2);
  const std::vector<Grasp> grasps = random_antipodal_grasps(world, panda_hand(), Random(1));
  ASSERT_FALSE(grasps.empty());
  for (const Grasp& grasp : grasps) {
    EXPECT_GT(grasp.opening, 0.02);
    EXPECT_LT(grasp.opening, 0.08);
    EXPECT_LE(grasp.T_world_tool.linear()(2, 2), 0.0) << "approaches from above";
    EXPECT_NEAR(grasp.T_world_tool.linear().determinant(), 1.0, 1e-9);
  }
}

TEST_F(ClutterRoundTest, TheScaleOfAnImageIsFoundFromTheTable) {
  const ClutterWorld world(objects_, ClutterKind::packed, 3, 2);
  const Plane table{Eigen::Vector3d::UnitZ(), -clutter::table_height};
  ClutterNoiseOptions exact;
  exact.enabled = false;
  ClutterView view = clutter_views(world, 1, exact, 1).front();
  EXPECT_NEAR(depth_scale(view, clutter_camera(), table), 1.0, 5e-4);
  for (float& depth : view.frame.depth) depth *= 1.06F;
  EXPECT_NEAR(depth_scale(view, clutter_camera(), table), 1.06, 5e-4);
  for (float& depth : view.frame.depth) depth = 0.0F;
  EXPECT_EQ(depth_scale(view, clutter_camera(), table), 1.0);
}

TEST_F(ClutterRoundTest, TheGripperIsVisibleInTheImageOfAGrasp) {
  const ClutterWorld world(objects_, ClutterKind::packed, 1, 4);
  Grasp grasp;
  grasp.T_world_tool.linear() =
      Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()).toRotationMatrix();
  grasp.T_world_tool.translation() = Eigen::Vector3d(0.15, 0.15, 0.2);
  const ColorImage image = grasp_image(world, grasp);
  std::size_t orange = 0;
  for (Eigen::Index i = 0; i < image.pixels.rows(); ++i)
    orange += image.pixels(i, 0) > 120 && image.pixels(i, 2) < 10 ? 1 : 0;
  EXPECT_GT(orange, image.size.pixels() / 50);
  EXPECT_LT(orange, image.size.pixels() / 2);
}

ClutterRound made_round(int placed, int removed, int attempts) {
  ClutterRound round;
  round.placed = placed;
  round.removed = removed;
  for (int i = 0; i < attempts; ++i) {
    round.attempts.emplace_back();
    round.attempts.back().aimed = "cube";
    round.attempts.back().outcome.end = i < removed ? GraspEnd::success : GraspEnd::slipped;
  }
  return round;
}

TEST(ClutterReport, RatesCountAttemptsAndObjectsOfAllRounds) {
  const std::vector<ClutterRound> rounds{made_round(5, 4, 5), made_round(3, 1, 3)};
  const RoundShare success = grasp_success_rate(rounds), removed = declutter_rate(rounds);
  EXPECT_DOUBLE_EQ(success.value, 5.0 / 8.0);
  EXPECT_DOUBLE_EQ(removed.value, 5.0 / 8.0);
  EXPECT_DOUBLE_EQ(success.low, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(success.high, 4.0 / 5.0);
}

TEST(ClutterReport, ThatNothingFailedDoesNotMakeTheIntervalEmpty) {
  const std::vector<ClutterRound> rounds(3, made_round(3, 3, 3));
  const RoundShare success = grasp_success_rate(rounds);
  EXPECT_DOUBLE_EQ(success.value, 1.0);
  EXPECT_NEAR(success.low, 9.0 / (9.0 + 1.96 * 1.96), 1e-9);  // Wilson's for 9 of 9
  EXPECT_DOUBLE_EQ(success.high, 1.0);
}

TEST(ClutterReport, AShareOfNothingIsSaidToBeNone) {
  const RoundShare success = grasp_success_rate(std::vector{made_round(3, 0, 0)});
  EXPECT_EQ(success.text(), "none");
}

TEST(ClutterReport, TheIntervalNarrowsWithTheRounds) {
  std::vector<ClutterRound> few, many;
  for (int i = 0; i < 10; ++i) few.push_back(made_round(5, i % 2 == 0 ? 5 : 2, 5));
  for (int i = 0; i < 160; ++i) many.push_back(few[static_cast<std::size_t>(i % 10)]);
  const RoundShare a = declutter_rate(few), b = declutter_rate(many);
  EXPECT_DOUBLE_EQ(a.value, b.value);
  EXPECT_NEAR((b.high - b.low) / (a.high - a.low), 0.25, 0.06);
}

TEST(ClutterReport, ObjectsThatAreHalfHiddenAreCountedApart) {
  ClutterRound round = made_round(3, 1, 2);
  round.attempts[0].occlusion = 0.5;
  round.placed_objects = {{0, 0.7, true}, {1, 0.5, false}, {2, 0.1, false}};
  round.trials = {{0.9, true}, {0.6, false}, {0.5, std::nullopt}, {0.49, true}};
  const std::string report = format_clutter_report(std::vector{round});
  const std::size_t less = report.find("objects less hidden");
  ASSERT_NE(less, std::string::npos);
  const auto expect = [](const std::string& text, const char* line) {
    EXPECT_NE(text.find(line), std::string::npos) << line << " in\n" << text;
  };
  const std::string hidden = report.substr(0, less), others = report.substr(less);
  expect(hidden, "  grasp success rate 100.0 % (95 % interval 20.7 to 100.0), 1 of 1\n");
  expect(hidden, "  declutter rate, by occlusion at the start 50.0 %");
  expect(hidden, "  objects with a grasp 66.7 %");
  expect(hidden, "  success of their best grasp 50.0 %");
  expect(others, "  grasp success rate 0.0 %");
  expect(others, "  success of their best grasp 100.0 %");
}

TEST(ClutterReport, OneLinePerAttemptWithAsManyValuesAsNames) {
  const std::vector<ClutterRound> rounds{made_round(5, 1, 2)};
  const std::string csv = format_attempts_csv(rounds);
  std::vector<std::string> lines;
  for (std::size_t start = 0, end; (end = csv.find('\n', start)) != std::string::npos;
       start = end + 1)
    lines.push_back(csv.substr(start, end - start));
  ASSERT_EQ(lines.size(), 3);
  const auto commas = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  EXPECT_EQ(commas(lines[1]), commas(lines[0]));
  EXPECT_NE(lines[1].find(",1,success,"), std::string::npos);
  EXPECT_NE(lines[2].find(",0,slipped,"), std::string::npos);
  const std::string report = format_clutter_report(rounds);
  EXPECT_NE(report.find("grasp success rate 50.0 %"), std::string::npos) << report;
}

TEST(ClutterGallery, ListsEachAttemptWithItsImage) {
  std::vector<GalleryEntry> entries{{"a.png", {}}, {"b.png", {}}};
  entries[1].attempt.aimed = "mug";
  entries[1].attempt.outcome.end = GraspEnd::slipped;
  const std::string page = format_gallery("failures", entries);
  for (const char* text : {"a.png", "b.png", "mug", "slipped", "contact at the start"})
    EXPECT_NE(page.find(text), std::string::npos) << text;
}

TEST(ClutterMethods, AreKnownByTheirNames) {
  for (const GraspMethod method :
       {GraspMethod::symscene, GraspMethod::cylinders, GraspMethod::true_meshes,
        GraspMethod::antipodal, GraspMethod::random})
    EXPECT_EQ(parse_grasp_method(to_string(method)), method);
  for (const TableKnowledge known :
       {TableKnowledge::none, TableKnowledge::plane, TableKnowledge::scale})
    EXPECT_EQ(parse_table_knowledge(to_string(known)), known);
  EXPECT_THROW(parse_grasp_method("learned"), InputError);
  EXPECT_THROW(parse_table_knowledge("all"), InputError);
}

}  // namespace
}  // namespace symscene
