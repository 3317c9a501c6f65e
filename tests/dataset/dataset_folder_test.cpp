#include "symscene/dataset/dataset_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "io/io_support.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/image.hpp"
#include "symscene/io/intrinsics.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/simulation/simulation.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;
using io_test::TemporaryFolder;
using io_test::write_text;

/// Two objects on a table from one place, as a camera measures them.
struct SingleView {
  CameraIntrinsics camera;
  DepthImage depth;
  DepthImage labels;
};

SingleView two_objects(Index scale = 1) {
  SimulationOptions options;
  options.tabletop = {
      .objects = 2, .stacked = 0.0, .touching = 0.0, .min_gap = 0.06, .max_gap = 0.08, .seed = 3};
  options.camera.frames = 2;
  options.camera.radius = 0.7;
  options.camera.width = static_cast<int>(320 * scale);
  options.camera.height = static_cast<int>(240 * scale);
  options.camera.focal_length = 262.0 * scale;
  const SensorFrame frame = capture_frames(arrange_tabletop(options.tabletop), options)[0];
  const ImageSize size{320 * scale, 240 * scale};
  SingleView view{options.camera.intrinsics(), {size, {}}, {size, {}}};
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    view.depth.values.push_back(static_cast<std::uint16_t>(std::lround(1000.0F * frame.depth[i])));
    view.labels.values.push_back(
        static_cast<std::uint16_t>(frame.objects[i] < 2 ? frame.objects[i] + 1 : 0));
  }
  return view;
}

/// A folder with that view as "learn18" and as "other".
void write_views(const fs::path& dir, const SingleView& view) {
  fs::create_directories(dir);
  write_text(dir / "intrinsics.txt", format_intrinsics(view.camera));
  ColorImage grey{view.labels.size, Colors(view.labels.values.size(), 3)};
  for (std::size_t i = 0; i < view.labels.values.size(); ++i)
    grey.pixels.row(static_cast<Eigen::Index>(i))
        .setConstant(static_cast<std::uint8_t>(view.labels.values[i]));
  for (const char* name : {"learn18", "other"})
    write_text(dir / (std::string(name) + ".depth.png"), format_png(view.depth));
  write_text(dir / "learn18.label.png", format_png(view.labels));
  write_text(dir / "other.label.png", format_png(grey));
}

/// A scene of four points with two objects; the ground truth has the given text for their points.
void write_small_scene(const fs::path& dir, const std::string& a, const std::string& b) {
  write_scene(dir, {io_test::random_cloud(4, 1), {}, Plane{Eigen::Vector3d::UnitZ(), 0.0}});
  const auto object = [](const std::string& name, const std::string& points) {
    return R"({"name": ")" + name + R"(", "points": )" + points + R"(, "centroid": [0, 0, 0]})";
  };
  write_text(dir / "truth.json", R"({"table": [0, 0, 1, 0], "objects": [)" + object("can", a) +
                                     ", " + object("box", b) + "]}");
}

/// What is refused, and how.
template <class Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

void expect_in(const std::string& part, const std::string& text) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(SingleViews, BecomeScenesWithMasks) {
  const TemporaryFolder folder;
  write_views(folder / "views", two_objects());
  const DatasetListing listing = read_dataset(folder / "views");
  EXPECT_EQ(listing.layout, "single views");
  ASSERT_EQ(listing.entries.size(), 2U);
  EXPECT_EQ(listing.entries[0].name, "learn18");
  EXPECT_EQ(listing.entries[0].subset, "stacked boxes");
  EXPECT_EQ(listing.entries[1].subset, "");
  const LoadedEntry loaded = load_entry(listing.entries[0]);
  ASSERT_TRUE(loaded.scene.table && loaded.scene.occupancy);
  EXPECT_EQ(loaded.lost, (std::vector<std::string>{"", ""}));
  ASSERT_TRUE(loaded.labeled);
  EXPECT_EQ(loaded.labeled->labels.size(), loaded.labeled->camera.pixels());
  ASSERT_EQ(loaded.truth.objects.size(), 2U);
  std::size_t labelled = 0;
  for (const TrueObject& object : loaded.truth.objects) {
    labelled += object.points.size();
    EXPECT_TRUE(object.rotational.empty() && object.reflectional.empty());
    EXPECT_GT(loaded.scene.table->signed_distance(object.centroid), 0.0);
  }
  EXPECT_GT(static_cast<double>(labelled), 0.97 * loaded.scene.cloud.size());
}

TEST(SingleViews, PointsThatBridgeHolesTakeTheLabelAtTheBorder) {
  const TemporaryFolder folder;
  SingleView view = two_objects(2);
  for (std::size_t i = 0; i < view.depth.values.size(); ++i) {
    const bool is_hole = i % view.camera.width % 3 == 1;
    if (is_hole) view.depth.values[i] = view.labels.values[i] = 0;
  }
  write_views(folder / "views", view);
  const LoadedEntry loaded = load_entry(read_dataset(folder / "views").entries[0]);
  std::size_t labelled = 0;
  for (const TrueObject& object : loaded.truth.objects) labelled += object.points.size();
  EXPECT_GT(static_cast<double>(labelled), 0.97 * loaded.scene.cloud.size());
}

TEST(SingleViews, CountEveryLabelAndTellWhyAnObjectWasLost) {
  const TemporaryFolder folder;
  SingleView view = two_objects();
  // A label where nothing was measured.
  for (std::size_t i = 0; i < 4; ++i) {
    view.depth.values[i] = 0;
    view.labels.values[i] = 9;
  }
  write_views(folder / "views", view);
  const LoadedEntry loaded = load_entry(read_dataset(folder / "views").entries[0]);
  ASSERT_EQ(loaded.truth.objects.size(), 3U);
  EXPECT_TRUE(loaded.truth.objects[2].points.empty());
  EXPECT_EQ(loaded.truth.objects[2].name, "object 9");
  EXPECT_EQ(loaded.lost, (std::vector<std::string>{"", "", "no surface"}));
}

TEST(SingleViews, LeaveTheSpaceBehindObjectsNeverSeen) {
  const TemporaryFolder folder;
  write_views(folder / "views", two_objects());
  const LoadedEntry loaded = load_entry(read_dataset(folder / "views").entries[1]);
  ASSERT_EQ(loaded.truth.objects.size(), 2U);
  std::size_t known = 0, all = 0;
  for (const TrueObject& object : loaded.truth.objects) {
    for (const Index i : object.points) {
      // Some way on along the ray: inside the object or behind it.
      const Eigen::Vector3d point = loaded.scene.cloud.position(i).cast<double>();
      const Eigen::Vector3d behind = point + 0.02 * point.normalized();
      const OccupancyMap& map = *loaded.scene.occupancy;
      for (const OccupancyLeaf& leaf : map.leaves) {
        const double edge = std::ldexp(map.resolution, leaf.level);
        const Eigen::Vector3d corner((static_cast<double>(leaf.key[0]) - 32768.0) * map.resolution,
                                     (static_cast<double>(leaf.key[1]) - 32768.0) * map.resolution,
                                     (static_cast<double>(leaf.key[2]) - 32768.0) * map.resolution);
        const Eigen::Array3d within = (behind - corner).array();
        if ((within >= 0.0).all() && (within < edge).all())
          known += leaf.state == VoxelState::free ? 1 : 0;
      }
      if (++all % 50 == 0) break;
    }
  }
  EXPECT_LT(static_cast<double>(known), 0.1 * static_cast<double>(all));
}

TEST(SingleViews, ThatContradictThemselvesAreRefused) {
  const TemporaryFolder folder;
  const SingleView view = two_objects();
  const auto spoiled = [&](const std::string& name) {
    write_views(folder / name, view);
    return folder / name;
  };
  const fs::path no_label = spoiled("no_label");
  fs::remove(no_label / "other.label.png");
  expect_in("other.label.png: expected a label image for each depth image",
            refusal([&] { read_dataset(no_label); }));
  expect_in("2 depth, 1 label images", refusal([&] { read_dataset(no_label); }));
  fs::remove(no_label / "learn18.label.png");
  expect_in("found depth images without labels", refusal([&] { read_dataset(no_label); }));
  const fs::path no_depth = spoiled("no_depth");
  fs::remove(no_depth / "other.depth.png");
  expect_in("other.depth.png", refusal([&] { read_dataset(no_depth); }));
  const fs::path small = spoiled("small");
  write_text(small / "other.label.png",
             format_png(DepthImage{{2, 2}, std::vector<std::uint16_t>(4)}));
  expect_in("other.label.png: expected labels of the depth image's 320×240 pixels, found 2×2",
            refusal([&] { load_entry(read_dataset(small).entries[1]); }));
  ColorImage red{{320, 240}, Colors::Zero(320 * 240, 3)};
  red.pixels.col(0).setConstant(1);
  write_text(small / "other.label.png", format_png(red));
  expect_in("expected grey pixels", refusal([&] { load_entry(read_dataset(small).entries[1]); }));
  const fs::path other_camera = spoiled("other_camera");
  fs::remove(other_camera / "intrinsics.txt");
  expect_in("learn18.depth.png: expected the camera's 640×480 pixels, found 320×240",
            refusal([&] { load_entry(read_dataset(other_camera).entries[0]); }));
}

TEST(FoldersOfScenes, AreFoundTwoLevelsDownAndResultsAreNot) {
  const TemporaryFolder folder;
  for (const char* seed : {"seed10", "seed9"}) {
    write_small_scene(folder / "all" / seed / "scene", "[0, 1]", "[2]");
    fs::create_directories(folder / "all" / seed / "result");
    for (const char* file : {"cloud.ply", "objects.json"})
      write_text(folder / "all" / seed / "result" / file, "");
  }
  EXPECT_TRUE(is_dataset(folder / "all"));
  EXPECT_FALSE(is_dataset(folder / "all" / "seed9" / "scene"));
  const DatasetListing listing = read_dataset(folder / "all");
  ASSERT_EQ(listing.entries.size(), 2U);
  EXPECT_EQ(listing.entries[0].name, "seed9/scene");
  const LoadedEntry loaded = load_entry(listing.entries[1]);
  EXPECT_EQ(loaded.truth.objects.size(), 2U);
  EXPECT_EQ(loaded.truth.objects[0].points, (PointIndices{0, 1}));
}

TEST(FoldersOfScenes, MayHaveObjectsOfWhichTheCloudHasNoPoint) {
  const TemporaryFolder folder;
  write_small_scene(folder / "all" / "one", "[0, 1]", "[]");
  const LoadedEntry loaded = load_entry(read_dataset(folder / "all").entries.at(0));
  ASSERT_EQ(loaded.truth.objects.size(), 2U);
  EXPECT_TRUE(loaded.truth.objects[1].points.empty());
}

TEST(FoldersOfScenes, WithMissingOrContradictoryTruthAreRefused) {
  const TemporaryFolder folder;
  const fs::path dir = folder / "all" / "one";
  const auto refused = [&] {
    return refusal([&] { load_entry(read_dataset(folder / "all").entries.at(0)); });
  };
  write_small_scene(dir, "[0, 1]", "[1, 2]");
  expect_in(
      "truth.json: expected masks that share no point, found point 1 in object 0 (\"can\") "
      "and in object 1 (\"box\")",
      refused());
  write_small_scene(dir, "[0, 1]", "[4]");
  expect_in("truth.json", refused());
  expect_in("4", refused());
  write_small_scene(dir, "[0, 1]", "[2]");
  write_text(dir / "truth.json", R"({"table": [0, 0, 1, 0], "objects": []})");
  expect_in("truth.json: expected at least one object, found none", refused());
  write_small_scene(dir, "[0, 1]", "[2]");
  fs::remove(dir / "cloud.ply");
  expect_in("cloud.ply: expected the cloud of a scene with ground truth, found no such file",
            refused());
  write_small_scene(dir, "[0, 1]", "[2]");
  fs::remove(dir / "truth.json");
  expect_in("truth.json: expected the ground truth of the scene, found no such file", refused());
  fs::remove_all(dir);
  expect_in("found a folder without scenes", refused());
  fs::remove_all(folder / "all");
  expect_in("found nothing of that name", refused());
}

TEST(ObjectSegmentationDatabase, EveryObjectIsInTheCloudOfItsImage) {
  const auto data = io_test::data_folder();
  if (!data || !fs::exists(*data / "osd_learn")) GTEST_SKIP() << "no data";
  std::size_t points = 0, labelled = 0;
  for (const DatasetEntry& entry : read_dataset(*data / "osd_learn").entries) {
    const LoadedEntry loaded = load_entry(entry);
    EXPECT_TRUE(loaded.scene.table) << entry.name;
    EXPECT_EQ(loaded.truth.objects.size(), loaded.lost.size()) << entry.name;
    for (const std::string& loss : loaded.lost) EXPECT_EQ(loss, "") << entry.name;
    points += loaded.scene.cloud.size();
    for (const TrueObject& object : loaded.truth.objects) labelled += object.points.size();
  }
  EXPECT_GT(static_cast<double>(labelled), 0.98 * static_cast<double>(points));
}

}  // namespace
}  // namespace symscene
