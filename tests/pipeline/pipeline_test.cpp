#include "symscene/pipeline/pipeline.hpp"

#include <numeric>

#include <gtest/gtest.h>

#include "surfaces.hpp"
#include "symscene/core/error.hpp"
#include "symscene/evaluation/mask_metrics.hpp"
#include "symscene/io/result.hpp"
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

}  // namespace
}  // namespace symscene
