#include "symscene/io/scene.hpp"

#include "io/io_support.hpp"
#include "symscene/io/cloud.hpp"

namespace symscene {
namespace {

using namespace io_test;
namespace fs = std::filesystem;

Scene small_scene() {
  Scene scene;
  scene.cloud = random_cloud(30, 1);
  scene.occupancy = OccupancyMap{0.01, {{{8, 8, 8}, 3, VoxelState::free}}};
  scene.table = Plane{Eigen::Vector3d(0.6, 0.0, 0.8), -0.25};
  return scene;
}

TEST(Scene, WritingAndReadingGiveTheSame) {
  const TemporaryFolder folder;
  const Scene scene = small_scene();
  write_scene(folder / "scene", scene);
  const Scene again = read_scene(folder / "scene");
  expect_same(again.cloud, scene.cloud);
  ASSERT_TRUE(again.occupancy && again.table);
  EXPECT_EQ(again.occupancy->resolution, 0.01);
  ASSERT_EQ(again.occupancy->leaves.size(), 1U);
  EXPECT_EQ(again.table->normal, scene.table->normal);
  EXPECT_EQ(again.table->offset, scene.table->offset);
  EXPECT_TRUE(again.warnings.empty());
}

TEST(Scene, WithoutTableThereIsAWarning) {
  const TemporaryFolder folder;
  write_scene(folder / "scene", Scene{random_cloud(5, 2), {}, {}});
  const Scene scene = read_scene(folder / "scene");
  EXPECT_FALSE(scene.occupancy || scene.table);
  // What a missing occupancy means is the pipeline's to say, which also gets scenes without files.
  ASSERT_EQ(scene.warnings.size(), 1U);
  EXPECT_NE(scene.warnings[0].find("table_plane.txt is missing"), std::string::npos);
}

TEST(Scene, OfABareTableNeedsNoOccupancy) {
  const TemporaryFolder folder;
  write_scene(folder / "scene", Scene{{}, {}, Plane{Eigen::Vector3d::UnitZ(), 0.0}});
  EXPECT_EQ(read_scene(folder / "scene").warnings, std::vector<std::string>{});
}

TEST(Scene, TheCloudMayBeAPcdFile) {
  const TemporaryFolder folder;
  const PointCloud cloud = random_cloud(5, 3);
  fs::create_directory(folder / "scene");
  write_cloud(folder / "scene/cloud.pcd", cloud);
  expect_same(read_scene(folder / "scene").cloud, cloud);
}

TEST(Scene, OtherFoldersAreRefusedAndTheContentsOfASceneFolderNamed) {
  const TemporaryFolder folder;
  const std::string expected =
      ": expected a scene folder, which holds cloud.ply (or cloud.pcd), occupancy.bt and "
      "table_plane.txt, found ";
  write_text(folder / "file", "x");
  fs::create_directory(folder / "empty");
  const auto message = [&](const std::string& name) {
    return refusal([&] { read_scene(folder / name); });
  };
  EXPECT_EQ(message("none"), (folder / "none").string() + expected + "nothing of that name");
  EXPECT_EQ(message("file"), (folder / "file").string() + expected + "a file");
  EXPECT_EQ(message("empty"),
            (folder / "empty").string() + expected + "a folder with no cloud.ply");
}

TEST(Scene, AFailedWriteLeavesTheOldSceneUnchanged) {
  const TemporaryFolder folder;
  const Scene scene = small_scene();
  write_scene(folder / "scene", scene);
  Scene wrong = small_scene();
  wrong.cloud.normals.conservativeResize(3, 3);
  EXPECT_THROW(write_scene(folder / "scene", wrong), InputError);
  wrong = small_scene();
  wrong.occupancy->leaves.push_back(wrong.occupancy->leaves.front());
  EXPECT_THROW(write_scene(folder / "scene", wrong), InputError);
  EXPECT_THROW(write_scene(folder / "scene", scene, {.scene_json = "{not JSON"}), InputError);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"scene"});
  expect_same(read_scene(folder / "scene").cloud, scene.cloud);
}

TEST(Scene, ASceneOfAnotherProgramIsNotReplaced) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "dataset");
  write_cloud(folder / "dataset/cloud.pcd", random_cloud(5, 3));
  EXPECT_THROW(write_scene(folder / "dataset", small_scene()), InputError);
  write_text(folder / "dataset/scene.json", "{}");
  EXPECT_THROW(write_scene(folder / "dataset", small_scene()), InputError);
}

TEST(Scene, GroundTruthAndParametersAreWrittenToo) {
  const TemporaryFolder folder;
  write_scene(folder / "scene", small_scene(),
              {.scene_json = "{\"seed\": 7}", .truth_json = "{\"objects\": []}"});
  EXPECT_EQ(read_text(folder / "scene/scene.json"), "{\"seed\": 7}");
  EXPECT_EQ(read_text(folder / "scene/truth.json"), "{\"objects\": []}");
}

TEST(Scene, IsWrittenToARelativePathWithoutAFolder) {
  const TemporaryFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder / ".");
  EXPECT_NO_THROW(write_scene("scene", small_scene()));
  std::filesystem::current_path(before);
  EXPECT_TRUE(std::filesystem::exists(folder / "scene/cloud.ply"));
}

TEST(Scene, TheSampleSceneIsReadCompletely) {
  const auto data = data_folder();
  if (!data) GTEST_SKIP() << "skipped: no data";
  const Scene scene = read_scene(*data / "ctd_sample");
  EXPECT_EQ(scene.cloud.size(), 88365U);
  ASSERT_TRUE(scene.occupancy && scene.table);
  EXPECT_EQ(scene.occupancy->resolution, 0.005);
  EXPECT_NEAR(scene.table->normal.norm(), 1.0, 1e-12);
}

}  // namespace
}  // namespace symscene
