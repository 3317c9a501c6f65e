#include "symscene/dataset/scene_maker.hpp"

#include <gtest/gtest.h>

#include <set>

#include "io/ply.hpp"
#include "simulation/shapes.hpp"
#include "symscene/core/error.hpp"
#include "symscene/ground_truth/truth_file.hpp"
#include "symscene/io/octomap.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

DatasetOptions small_options() {
  DatasetOptions options;
  options.max_objects = 2;
  options.arranged_every = 1;
  options.camera = {
      .frames = 6, .arc = 0.05, .radius = 0.7, .width = 320, .height = 240, .focal_length = 262.0};
  return options;
}

std::string bytes(const MadeScene& made) {
  return format_ply(made.scene.cloud) + format_octomap(*made.scene.occupancy) +
         format_truth(made.truth);
}

TEST(SceneMaker, MakesTheSameSceneWithGroundTruthForAnyNumberOfThreads) {
  const auto made_with = [](std::size_t threads) {
    return testing::with_threads(
        threads, [] { return make_scene(small_options(), Split::training, {}, 1); });
  };
  const MadeScene made = made_with(1);
  ASSERT_TRUE(made.facts.good);
  EXPECT_EQ(made.facts.index, 1U);
  EXPECT_EQ(made.facts.fused, 6U);
  EXPECT_LT(made.facts.path_error, 0.01);
  EXPECT_EQ(made.facts.objects_seen, made.truth.objects.size());
  EXPECT_GE(made.facts.objects_seen, 1U);
  EXPECT_FALSE(made.stages.empty());
  EXPECT_EQ(bytes(made), bytes(made_with(2)));
}

TEST(SceneMaker, MakesASceneOfASingleFrame) {
  DatasetOptions options = small_options();
  options.camera.frames = 1;
  const MadeScene made = make_scene(options, Split::training, {}, 1);
  ASSERT_TRUE(made.facts.good) << made.facts.failed.at(0).reason;
  EXPECT_EQ(made.facts.frames, 1U);
  EXPECT_EQ(made.facts.fused, 1U);
  EXPECT_EQ(made.facts.path_error, 0.0);
  ASSERT_TRUE(made.scene.table);
  // The ground truth is moved by the one pose that is known, so that both tables are one.
  EXPECT_LT(angle_between(made.scene.table->normal, made.truth.table.normal), radians(2.0));
  EXPECT_GE(made.truth.objects.size(), 1U);
  for (const TrueObject& object : made.truth.objects) {
    const Eigen::Vector3d seen = centroid(made.scene.cloud.positions, object.points);
    EXPECT_LT((seen - object.centroid).norm(), 0.1);
  }
}

TEST(SceneMaker, TriesOtherSeedsAndRecordsWhyWhereTrackingFails) {
  DatasetOptions options = small_options();
  options.attempts = 2;
  options.camera.width = 80;
  options.camera.height = 60;
  options.camera.focal_length = 65.0;
  const MadeScene made = make_scene(options, Split::test, {}, 0);
  EXPECT_FALSE(made.facts.good);
  ASSERT_EQ(made.facts.failed.size(), 2U);
  EXPECT_NE(made.facts.failed[0].seed, made.facts.failed[1].seed);
  EXPECT_FALSE(made.facts.failed[0].reason.empty());
}

TEST(SceneMaker, DropsScannedModelsAmongProceduralOnes) {
  if (!has_physics()) GTEST_SKIP() << "no physics";
  DatasetOptions options = small_options();
  options.arranged_every = 0;
  options.min_objects = options.max_objects = 3;
  const std::vector<ObjectModel> models = {
      {"scanned", make_box(Eigen::Vector3d(0.1, 0.08, 0.06), 0.1), {}, {}, false}};
  options.scanned = 1.0;
  for (const PlacedObject& placed : place_objects(options, models, 3, 5, true).objects)
    EXPECT_EQ(placed.object.name, "scanned");
  options.scanned = 0.0;
  for (const PlacedObject& placed : place_objects(options, models, 3, 5, true).objects) {
    EXPECT_NE(placed.object.name, "scanned");
    EXPECT_EQ(placed.object.name.find('#'), std::string::npos);
  }
}

TEST(SceneMaker, DropsHouseholdObjectsAtTheirScale) {
  if (!has_physics()) GTEST_SKIP() << "no physics";
  DatasetOptions options = small_options();
  const auto largest_extent = [&] {
    float largest = 0.0F;
    for (const PlacedObject& placed : place_objects(options, {}, 4, 5, true).objects)
      largest = std::max(largest, bounding_box(placed.object.mesh.vertices).extent().maxCoeff());
    return largest;
  };
  const float real = largest_extent();
  options.min_scale = options.max_scale = 0.5;
  EXPECT_NEAR(largest_extent(), 0.5F * real, 0.1F * real);
}

TEST(SceneMaker, DropsNoModelTwiceWhileThereAreOthers) {
  if (!has_physics()) GTEST_SKIP() << "no physics";
  DatasetOptions options = small_options();
  options.scanned = 1.0;
  options.min_spread = options.max_spread = 0.08;
  std::vector<ObjectModel> models;
  for (const char* name : {"a", "b", "c", "d"})
    models.push_back({name, make_box(Eigen::Vector3d(0.06, 0.05, 0.04), 0.1), {}, {}, false});
  std::set<std::string> used;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    std::set<std::string> names;
    const Tabletop tabletop = place_objects(options, models, 3, seed, true);
    for (const PlacedObject& placed : tabletop.objects) names.insert(placed.object.name);
    EXPECT_EQ(names.size(), tabletop.objects.size());
    used.insert(names.begin(), names.end());
  }
  EXPECT_EQ(used.size(), 4U);
}

TEST(SceneMaker, RefusesOptionsOutOfRange) {
  for (const auto& spoil : std::vector<std::function<void(DatasetOptions&)>>{
           [](auto& o) { o.scenes = 0; }, [](auto& o) { o.min_objects = 0; },
           [](auto& o) { o.min_objects = 3; }, [](auto& o) { o.max_objects = 21; },
           [](auto& o) { o.arranged_every = -1; }, [](auto& o) { o.scanned = 1.5; },
           [](auto& o) { o.max_spread = 0.001; }, [](auto& o) { o.min_scale = 0.0; },
           [](auto& o) { o.max_scale = 0.5; }, [](auto& o) { o.attempts = 0; },
           [](auto& o) { o.max_error = 0.0; }, [](auto& o) { o.camera.frames = 0; },
           [](auto& o) { o.making.truth.tolerance = 0.0; }}) {
    DatasetOptions options = small_options();
    spoil(options);
    EXPECT_THROW(options.validate(), InputError);
  }
}

}  // namespace
}  // namespace symscene
