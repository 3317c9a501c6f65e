#include "dataset/varied_scene.hpp"

#include <set>

#include <gtest/gtest.h>

#include "simulation/shapes.hpp"
#include "symscene/core/error.hpp"
#include "symscene/dataset/scene_maker.hpp"

namespace symscene {
namespace {

SceneVariationOptions varied() {
  SceneVariationOptions options;
  options.enabled = true;
  return options;
}

TEST(SceneVariation, LeavesThePlanUnlessItIsEnabled) {
  const ScenePlan plan = vary_scene({}, {}, 7);
  EXPECT_EQ(plan.sweep.sensor.model, SensorNoiseOptions{}.model);
  EXPECT_EQ(plan.sweep.camera.frames, SweepOptions{}.camera.frames);
  EXPECT_EQ(plan.making.poses, "tracked");
}

TEST(SceneVariation, DrawsEveryKindWithinItsRange) {
  const SceneVariationOptions options = varied();
  std::set<std::string> sensors, poses;
  std::set<int> widths;
  int singles = 0, steep = 0, flat = 0, rooms = 0, lines = 0, bare = 0;
  constexpr int count = 400;
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    const ScenePlan plan = vary_scene(options, {}, seed);
    const CameraArcOptions& camera = plan.sweep.camera;
    EXPECT_NO_THROW(plan.sweep.validate());
    EXPECT_NO_THROW(plan.making.validate());
    EXPECT_GE(camera.radius, options.min_distance);
    EXPECT_LE(camera.radius, options.max_distance);
    EXPECT_LE(camera.frames, options.max_tracked_frames);
    EXPECT_EQ(plan.making.poses == "exact", camera.frames <= options.max_few_frames);
    sensors.insert(plan.sweep.sensor.model);
    poses.insert(plan.making.poses);
    widths.insert(camera.width);
    singles += camera.frames == 1 ? 1 : 0;
    steep += camera.min_elevation > 1.3 ? 1 : 0;
    flat += camera.min_elevation < 0.4 ? 1 : 0;
    rooms += plan.sweep.tabletop.table.height > 0.0 ? 1 : 0;
    lines += plan.sweep.sensor.missing_lines > 0.0 ? 1 : 0;
    bare += plan.with_occupancy ? 0 : 1;
  }
  EXPECT_EQ(sensors.size(), 3U);
  EXPECT_EQ(poses.size(), 2U);
  EXPECT_EQ(widths.size(), 3U);
  EXPECT_NEAR(singles, options.single_views * count, 40);
  EXPECT_NEAR(lines, options.missing_lines * count, 40);
  EXPECT_NEAR(bare, options.no_occupancy * count, 40);
  for (const int kind : {steep, flat, rooms}) EXPECT_GT(kind, 20);
}

TEST(SceneVariation, ObjectsStandOnTheTableAndKeepClearOfTheCamera) {
  const SceneVariationOptions options = varied();
  Tabletop tabletop;
  tabletop.objects.emplace_back();
  tabletop.objects[0].object.mesh = make_box({0.1, 0.1, 0.2}, 0.1);
  tabletop.objects[0].T_world_object.translation().x() = 0.5;
  ScenePlan plan;
  plan.sweep.camera.radius = 0.3;
  plan.sweep.tabletop.table = {.length = 0.4, .width = 0.4, .height = 0.7, .wall_distance = 0.2};
  fit_to_objects(options, tabletop, plan);
  EXPECT_GT(tabletop.table.length, 2 * 0.55);
  EXPECT_GE(tabletop.table.wall_distance, 0.5 * tabletop.table.length);
  EXPECT_GT(plan.sweep.camera.radius, 0.55 + options.clearance);
}

TEST(SceneVariation, MakesASceneOfFewExactViewsThatRecordsWhatWasDrawn) {
  DatasetOptions options;
  options.min_objects = options.max_objects = 2;
  options.arranged_every = 1;
  options.camera = {
      .frames = 6, .arc = 1.5, .radius = 0.7, .width = 320, .height = 240, .focal_length = 262.0};
  options.variation = varied();
  options.variation.cameras = false;
  options.variation.few_views = 1.0;
  options.variation.single_views = 0.0;
  options.variation.min_few_frames = options.variation.max_few_frames = 3;
  options.variation.min_distance = options.variation.max_distance = 0.7;
  options.variation.max_elevation = 0.8;
  options.variation.no_occupancy = 1.0;
  const MadeScene made = make_scene(options, Split::training, {}, 1);
  ASSERT_TRUE(made.facts.good) << made.facts.failed.at(0).reason;
  ASSERT_TRUE(made.facts.plan);
  EXPECT_EQ(made.facts.plan->making.poses, "exact");
  EXPECT_EQ(made.facts.frames, 3U);
  EXPECT_EQ(made.facts.fused, made.facts.frames);
  EXPECT_LT(made.facts.path_error, 1e-9);
  EXPECT_FALSE(made.scene.occupancy);
  EXPECT_GE(made.truth.objects.size(), 1U);
}

TEST(SceneVariation, RefusesOptionsThatContradictEachOther) {
  for (const auto& spoil : std::vector<std::function<void(SceneVariationOptions&)>>{
           [](auto& o) { o.max_distance = 0.1; }, [](auto& o) { o.max_noise = 0.1; },
           [](auto& o) { o.stereo = 0.9; }, [](auto& o) { o.single_views = 0.9; },
           [](auto& o) { o.endless_tables = 0.9; }, [](auto& o) { o.max_elevation = 0.1; },
           [](auto& o) { o.max_tracked_frames = 3; }}) {
    SceneVariationOptions options;
    spoil(options);
    EXPECT_THROW(options.validate(), InputError);
  }
  SweptSceneOptions making;
  making.poses = "guessed";
  EXPECT_THROW(making.validate(), InputError);
}

}  // namespace
}  // namespace symscene
