#include "symscene/pipeline/pipeline.hpp"

#include <cstdlib>
#include <filesystem>
#include <numeric>

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "core/random.hpp"
#include "surfaces.hpp"
#include "symscene/core/error.hpp"
#include "symscene/evaluation/mask_metrics.hpp"
#include "symscene/io/result.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/simulation/simulation.hpp"
#include "symscene/symmetry/single_object.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

const SimulatedScene& table_of_four() {
  static const SimulatedScene scene = [] {
    SimulationOptions options;
    options.tabletop.objects = 4;
    options.tabletop.seed = 44;
    options.tabletop.random_frame = true;
    return simulate_tabletop(options);
  }();
  return scene;
}

std::vector<PointIndices> masks_of(const SegmentationResult& result) {
  std::vector<PointIndices> masks;
  for (const SceneObject& object : result.objects) masks.push_back(object.points);
  return masks;
}

const SegmentationResult& result_of_four() {
  static const SegmentationResult result = segment_scene(table_of_four().scene);
  return result;
}

/// A cloud with normals without occupancy and table: a small valid scene to spoil.
Scene plain_scene() {
  Scene scene = table_of_four().scene;
  scene.occupancy.reset();
  scene.table.reset();
  return scene;
}

TEST(Pipeline, FindsTheObjectsOfASimulatedTable) {
  const SimulatedScene& simulated = table_of_four();
  const SegmentationResult& result = result_of_four();
  const auto truth = transfer_masks(simulated.scene.cloud, simulated.truth, result.cloud);
  const DetectionCounts masks = mask_detections(overlap_matrix(truth, masks_of(result)), 0.9);
  EXPECT_EQ(masks.correct, simulated.truth.objects.size());
  EXPECT_LE(result.objects.size(), simulated.truth.objects.size() + 1);
}

TEST(Pipeline, GivesTheSameBytesForAnyNumberOfThreads) {
  std::vector<std::string> texts;
  for (const std::size_t threads : {1U, 2U, 8U}) {
    texts.push_back(testing::with_threads(
        threads, [] { return format_objects_json(segment_scene(table_of_four().scene), false); }));
  }
  EXPECT_EQ(texts[0], texts[1]);
  EXPECT_EQ(texts[0], texts[2]);
}

TEST(Pipeline, ReturnsWellFormedObjects) {
  const SegmentationResult& result = result_of_four();
  EXPECT_TRUE(result.warnings.empty());
  ASSERT_EQ(result.completed.size(), result.objects.size());
  double last_score = 1.0;
  for (const SceneObject& object : result.objects) {
    ASSERT_TRUE(object.score);
    EXPECT_LE(*object.score, last_score);
    EXPECT_GE(*object.score, 0.0);
    last_score = *object.score;
    EXPECT_GE(object.confidence, 0.0);
    EXPECT_LE(object.confidence, 1.0);
    EXPECT_TRUE(std::is_sorted(object.points.begin(), object.points.end()));
    EXPECT_LT(object.points.back(), result.cloud.size());
    ASSERT_TRUE(object.centroid);
    for (const ObjectAxis& axis : object.rotational)
      EXPECT_LT(axis.axis.distance(*object.centroid), 1e-6);
    EXPECT_TRUE(object.centroid->allFinite());
  }
  EXPECT_FALSE(result.timings.empty());
  EXPECT_EQ(result.funnel.back().count, result.objects.size());
}

TEST(Pipeline, ClosesTheSurfaceOfEveryObjectNearItsTrueVolume) {
  const SimulatedScene& simulated = table_of_four();
  const SegmentationResult& result = result_of_four();
  ASSERT_EQ(result.surfaces.size(), result.objects.size());
  const auto truth = transfer_masks(simulated.scene.cloud, simulated.truth, result.cloud);
  const OverlapMatrix overlaps = overlap_matrix(truth, masks_of(result));
  for (Eigen::Index k = 0; k < overlaps.rows(); ++k) {
    Eigen::Index id = 0;
    ASSERT_GT(overlaps.row(k).maxCoeff(&id), 0.9);
    const SceneObject& object = result.objects[static_cast<std::size_t>(id)];
    ASSERT_TRUE(object.solid);
    const PlacedObject& placed =
        simulated.tabletop.objects[simulated.sources[static_cast<std::size_t>(k)]];
    const SolidProperties true_solid = solid_properties(world_mesh(placed));
    EXPECT_LT((object.solid->centre_of_mass - true_solid.centre_of_mass).norm(), 0.015);
    EXPECT_GT(object.solid->volume, 0.75 * true_solid.volume);
    EXPECT_LT(object.solid->volume, 1.7 * true_solid.volume);  // thin walls come out thicker
  }
}

/// Whether a warning of the result contains `part`.
bool warns(const SegmentationResult& result, const std::string& part) {
  return std::any_of(
      result.warnings.begin(), result.warnings.end(),
      [&](const std::string& warning) { return warning.find(part) != std::string::npos; });
}

TEST(Pipeline, FindsObjectsWithoutOccupancyAndWarns) {
  Scene scene = plain_scene();
  scene.warnings = {"of its reader"};
  const SegmentationResult result = segment_scene(scene);
  ASSERT_EQ(result.warnings.size(), 2U);
  EXPECT_EQ(result.warnings[0], "of its reader");
  EXPECT_TRUE(warns(result, "never seen"));
  EXPECT_FALSE(result.objects.empty());
}

TEST(Pipeline, TakesCoarserFreeSpaceOfALargeSceneAndWarns) {
  PipelineOptions options;
  options.distance_field.max_voxels = 1000000;
  const SegmentationResult result = segment_scene(table_of_four().scene, options);
  EXPECT_TRUE(warns(result, "distance_field.max_voxels"));
  EXPECT_EQ(result.objects.size(), result_of_four().objects.size());
}

TEST(Pipeline, WithoutSymmetriesHiddenSidesEndAtTheVisibleHull) {
  PipelineOptions options;
  options.complete_by_symmetry = false;
  const SegmentationResult& on = result_of_four();
  const SegmentationResult off = segment_scene(table_of_four().scene, options);
  ASSERT_EQ(off.objects.size(), on.objects.size());
  std::size_t images = 0;
  for (std::size_t i = 0; i < on.objects.size(); ++i) {
    images += on.completed[i].size();
    EXPECT_TRUE(off.completed[i].empty());
    EXPECT_EQ(off.objects[i].points, on.objects[i].points);
    EXPECT_EQ(off.objects[i].rotational.size(), on.objects[i].rotational.size());
    EXPECT_GT(off.surfaces[i].mesh.triangles.rows(), 0);
  }
  EXPECT_GT(images, 0);
}

TEST(Pipeline, EstimatesMissingNormalsAndWarns) {
  const SimulatedScene& simulated = table_of_four();
  Scene scene = simulated.scene;
  scene.cloud.normals.resize(0, 3);
  const SegmentationResult result = segment_scene(scene);
  ASSERT_TRUE(result.cloud.has_normals());
  EXPECT_TRUE(warns(result, "no usable normals"));
  const auto truth = transfer_masks(simulated.scene.cloud, simulated.truth, result.cloud);
  EXPECT_GE(mask_detections(overlap_matrix(truth, masks_of(result)), 0.75).correct + 1,
            simulated.truth.objects.size());
}

TEST(Pipeline, LeavesOutPointsAndNormalsThatAreNotFinite) {
  Scene scene = table_of_four().scene;
  scene.cloud.positions.row(10).setConstant(std::nanf(""));
  scene.cloud.positions(20, 1) = std::numeric_limits<float>::infinity();
  scene.cloud.normals.row(30).setConstant(std::nanf(""));
  scene.cloud.normals.row(40).setZero();
  const SegmentationResult result = segment_scene(scene);
  EXPECT_TRUE(result.cloud.positions.allFinite());
  EXPECT_TRUE(result.cloud.normals.allFinite());
  EXPECT_FALSE(result.objects.empty());
}

TEST(Pipeline, RefusesCloudsWithoutAPoint) {
  Scene scene = plain_scene();
  scene.cloud = PointCloud{};
  EXPECT_THROW(segment_scene(scene), InputError);
  scene = plain_scene();
  scene.cloud.positions.setConstant(std::nanf(""));
  EXPECT_THROW(segment_scene(scene), InputError);
}

TEST(Pipeline, NamesTheUnitIfItRefusesACloudInMillimetres) {
  Scene scene = plain_scene();
  scene.cloud.positions *= 1000.0F;
  try {
    segment_scene(scene);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("metres"), std::string::npos) << error.what();
  }
}

TEST(Pipeline, FindsNothingInAPatchAndRefusesLonePoints) {
  const Scene scene = plain_scene();
  const auto first = [&](Index count) {
    Scene few = scene;
    PointIndices indices(count);
    std::iota(indices.begin(), indices.end(), Index{0});
    few.cloud = select(scene.cloud, indices);
    return few;
  };
  EXPECT_THROW(segment_scene(first(1)), InputError);
  EXPECT_THROW(segment_scene(first(2)), InputError);
  Scene patch = first(50);
  EXPECT_TRUE(segment_scene(patch).objects.empty());
  patch.cloud.normals.resize(0, 3);
  EXPECT_TRUE(segment_scene(patch).objects.empty());
}

TEST(Pipeline, LeavesOutAFlyingPixel) {
  Scene scene = table_of_four().scene;
  const std::size_t objects = result_of_four().objects.size();
  scene.cloud.positions.row(0) += Eigen::RowVector3f(6.0F, 0.0F, 0.0F);
  EXPECT_EQ(segment_scene(scene).objects.size(), objects);
}

TEST(Pipeline, WarnsOfATableWhoseNormalPointsDown) {
  Scene scene = table_of_four().scene;
  scene.table = Plane{-scene.table->normal, -scene.table->offset};
  EXPECT_TRUE(warns(segment_scene(scene), "below the table"));
}

TEST(Pipeline, WarnsOfAnOccupancyMapInAnotherFrame) {
  Scene scene = table_of_four().scene;
  scene.table.reset();
  scene.cloud.positions.rowwise() += 5.0F * Eigen::RowVector3f::UnitX();
  EXPECT_TRUE(warns(segment_scene(scene), "no observed voxel"));
}

TEST(Pipeline, WarnsIfManyPointsAreStray) {
  PipelineOptions options;
  options.stray_neighbors = 12;  // more than the points at the rim of a surface have
  options.stray_radius = 0.011;
  EXPECT_TRUE(warns(segment_scene(plain_scene(), options), "are left out"));
}

TEST(Pipeline, RefusesOptionsOutOfRange) {
  PipelineOptions options;
  options.voxel_size = 0.0;
  EXPECT_THROW(segment_scene(plain_scene(), options), InputError);
  options = {};
  options.selection.max_overlap = 2.0;
  EXPECT_THROW(segment_scene(plain_scene(), options), InputError);
}

/// The floating-point fields of an options struct and of those in it, by their full names.
class RealFields {
 public:
  template <class Options>
  explicit RealFields(Options& options) {
    collect("", options);
  }

  const std::vector<std::pair<std::string, double*>>& fields() const { return fields_; }

 private:
  struct Collector {
    RealFields& all;
    std::string prefix;

    template <class Value, class... Rest>
    void operator()(const char* name, Value& value, const char* /*unit*/, const Rest&...) const {
      if constexpr (std::is_same_v<Value, double>) all.fields_.emplace_back(prefix + name, &value);
    }
    template <class Group>
    void operator()(const char* name, Group& group) const {
      all.collect(prefix + name + ".", group);
    }
  };

  template <class Options>
  void collect(const std::string& prefix, Options& options) {
    visit_options(options, Collector{*this, prefix});
  }

  std::vector<std::pair<std::string, double*>> fields_;
};

template <class Options>
void expect_nan_refused_in_every_field() {
  Options options;
  options.validate();
  const RealFields real(options);
  ASSERT_GT(real.fields().size(), 20U);
  for (const auto& [name, value] : real.fields()) {
    const double before = *value;
    *value = std::nan("");
    EXPECT_THROW(options.validate(), InputError) << name;
    *value = before;
  }
}

TEST(PipelineOptions, RefuseNanInEveryFieldOfEveryStage) {
  expect_nan_refused_in_every_field<PipelineOptions>();
}

TEST(SingleObjectOptions, RefuseNanInEveryFieldOfEveryStage) {
  expect_nan_refused_in_every_field<SingleObjectOptions>();
}

std::filesystem::path real_scene() {
  const char* folder = std::getenv("SYMSCENE_DATA");
  const std::filesystem::path data =
      folder != nullptr ? std::filesystem::path(folder)
                        : std::filesystem::path(SYMSCENE_SOURCE_DIR) / "../shared/data";
  return data / "ctd_sample";
}

/// An object of the real scene: where its points are in the mean [m] and how many these are.
struct Expected {
  const char* name;
  Eigen::Vector3d place;
  double size;
};

const std::vector<Expected>& objects_of_real_scene() {
  static const std::vector<Expected> objects{
      {"jug", {0.27, -0.26, 1.19}, 2529.0}, {"bottle", {0.17, 0.01, 0.87}, 1271.0},
      {"bear", {0.05, 0.06, 0.74}, 4258.0}, {"carton", {0.17, 0.08, 0.82}, 1179.0},
      {"can", {0.21, -0.09, 0.95}, 1644.0}, {"noodle cup", {0.33, -0.13, 1.12}, 1639.0},
      {"bowl", {0.17, 0.08, 0.88}, 5014.0}, {"iron", {0.32, -0.01, 1.00}, 2586.0},
      {"pear", {0.22, -0.18, 1.09}, 426.0}, {"box", {0.08, -0.19, 0.97}, 5443.0}};
  return objects;
}

/// The sizes of the objects of a result that are about where an expected one is, and about as
/// large.
std::vector<double> sizes_like(const Expected& expected, const SegmentationResult& result,
                               const Eigen::Isometry3d& motion) {
  std::vector<double> sizes;
  for (const SceneObject& object : result.objects) {
    const Eigen::Vector3d place = centroid(result.cloud.positions, object.points);
    const auto size = static_cast<double>(object.points.size());
    if ((place - motion * expected.place).norm() < 0.03 &&
        std::abs(size - expected.size) < 0.5 * expected.size)
      sizes.push_back(size);
  }
  return sizes;
}

/// The expected objects that a result does not have, or not with about the expected size.
std::vector<std::string> missed_in(const SegmentationResult& result,
                                   const Eigen::Isometry3d& motion) {
  std::vector<std::string> missed;
  for (const Expected& expected : objects_of_real_scene()) {
    const std::vector<double> sizes = sizes_like(expected, result, motion);
    if (sizes.size() != 1 || std::abs(sizes[0] - expected.size) > 0.15 * expected.size)
      missed.emplace_back(expected.name);
  }
  return missed;
}

const SegmentationResult& segmented_real_scene() {
  static const SegmentationResult result = segment_scene(read_scene(real_scene()));
  return result;
}

TEST(Pipeline, FindsNineOfTheTenObjectsOfTheRealScene) {
  if (!std::filesystem::exists(real_scene())) GTEST_SKIP() << "skipped: no data";
  const SegmentationResult& result = segmented_real_scene();
  EXPECT_LE(result.objects.size(), 14U);
  const std::vector<std::string> missed = missed_in(result, Eigen::Isometry3d::Identity());
  EXPECT_LE(missed.size(), 1U) << fmt::format("{}", fmt::join(missed, ", "));
}

TEST(Pipeline, TheBearOfTheRealSceneHasItsMirrorPlane) {
  if (!std::filesystem::exists(real_scene())) GTEST_SKIP() << "skipped: no data";
  const Expected& bear = objects_of_real_scene()[2];
  ASSERT_STREQ(bear.name, "bear");
  // Figure 3.7 of the thesis: it runs along the back, between the ears.
  const ReflectionPlane expected{bear.place, Eigen::Vector3d(0.92, 0.31, 0.23).normalized()};
  const SameSymmetry is_same{bear.place, radians(10.0), 0.02};
  const std::vector<SceneObject>& objects = segmented_real_scene().objects;
  EXPECT_TRUE(std::any_of(objects.begin(), objects.end(), [&](const SceneObject& object) {
    return std::any_of(object.reflectional.begin(), object.reflectional.end(),
                       [&](const ObjectPlane& found) { return is_same(found.plane, expected); });
  }));
}

Eigen::Isometry3d random_pose(std::uint64_t seed) {
  Random random(seed);
  Eigen::Vector4d q;
  for (int k = 0; k < 4; ++k) q[k] = random.normal();
  Eigen::Isometry3d pose(Eigen::Quaterniond(q.normalized()));
  for (int k = 0; k < 3; ++k) pose.translation()[k] = random.uniform(-1.0, 1.0);
  return pose;
}

TEST(Pipeline, FindsEightOfTheTenObjectsOfTheRealSceneInAnyPoseWithoutOccupancy) {
  if (!std::filesystem::exists(real_scene())) GTEST_SKIP() << "skipped: no data";
  Scene scene = read_scene(real_scene());
  scene.occupancy.reset();
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Eigen::Isometry3d pose = random_pose(seed);
    Scene turned = scene;
    turned.cloud = testing::moved(scene.cloud, pose);
    turned.table->normal = pose.linear() * scene.table->normal;
    turned.table->offset = scene.table->offset - turned.table->normal.dot(pose.translation());
    const SegmentationResult result = segment_scene(turned);
    const std::vector<std::string> missed = missed_in(result, pose);
    EXPECT_LE(missed.size(), 2U) << "pose " << seed << ": "
                                 << fmt::format("{}", fmt::join(missed, ", "));
  }
}

}  // namespace
}  // namespace symscene
