#include "symscene/evaluation/scene_evaluation.hpp"

#include <gtest/gtest.h>

#include "symscene/core/error.hpp"
#include "symscene/core/thread_limit.hpp"
#include "symscene/evaluation/report.hpp"
#include "symscene/simulation/simulation.hpp"

namespace symscene {
namespace {

SimulatedScene two_objects() {
  SimulationOptions options;
  options.tabletop.objects = 2;
  options.camera.frames = 6;
  return simulate_tabletop(options);
}

Scene three_points() {
  Scene scene;
  scene.cloud.positions = Points::Identity(3, 3);
  return scene;
}

SceneTruth cups_of(std::initializer_list<PointIndices> masks) {
  SceneTruth truth;
  for (const PointIndices& mask : masks) {
    truth.objects.emplace_back();
    truth.objects.back().name = "cup";
    truth.objects.back().points = mask;
  }
  return truth;
}

/// Takes the whole cloud for one object, or for none.
BaselineSweep everything(const PointCloud& cloud) {
  PointIndices all;
  for (Index i = 0; i < cloud.size(); ++i) all.push_back(i);
  return {"everything", "share", {0.0, 1.0}, {{}, {all}}};
}

std::string complaint(const Scene& scene, const SceneTruth& truth) {
  try {
    require_usable_truth(scene, truth);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RequireUsableTruth, NamesTheObjectAndItsError) {
  const Scene scene = three_points();
  EXPECT_EQ(complaint(scene, cups_of({{0, 1}, {2}})), "");
  EXPECT_EQ(complaint(scene, cups_of({{0}, {}})), "");  // lost before segmentation
  EXPECT_NE(complaint(scene, cups_of({{3}})).find("indices below 3"), std::string::npos);
  EXPECT_NE(complaint(scene, cups_of({{0, 1}, {1}})).find("point 1 of object 0 too"),
            std::string::npos);
}

/// Everything of a scene's evaluation but the times.
std::string timeless(SceneEvaluation scene) {
  for (StageTime& time : scene.timings) time.seconds = 0.0;
  for (Sweep& sweep : scene.segmentation) sweep.seconds = 0.0;
  Evaluation evaluation;
  evaluation.add(std::move(scene));
  return report_json(evaluation, {"two", "today", "0", "nothing"});
}

TEST(EvaluateScene, SweepsEveryVariantAndBaselineEquallyForAnyNumberOfThreads) {
  const SimulatedScene scene = two_objects();
  EvaluationOptions options;
  options.baselines = {everything};
  const SceneEvaluation evaluation = evaluate_scene(scene.scene, scene.truth, options);
  ASSERT_EQ(evaluation.segmentation.size(), 5U);
  EXPECT_EQ(evaluation.segmentation[0].method, scored_method);
  EXPECT_EQ(evaluation.segmentation[0].counts.size(), 19U * 7U);
  EXPECT_EQ(evaluation.segmentation[1].method, full_method);
  EXPECT_EQ(evaluation.segmentation[1].counts.size(), 180U);
  EXPECT_EQ(evaluation.segmentation[2].method, reflectional_method);
  EXPECT_EQ(evaluation.segmentation[2].counts.size(), 30U);
  EXPECT_EQ(evaluation.segmentation[3].method, curve_method);
  EXPECT_EQ(evaluation.segmentation[3].counts.size(), 30U);
  EXPECT_EQ(evaluation.segmentation[4].method, "everything");
  EXPECT_EQ(evaluation.segmentation[4].counts[0].detections(Metric::masks_50).found, 0U);
  EXPECT_EQ(evaluation.segmentation[4].counts[1].detections(Metric::masks_50).found, 1U);
  ASSERT_EQ(evaluation.detection.size(), 3U);
  // Table 3.1: 15 values of M_S, 5 of the inlier ratio.
  const Sweep& of_curves = evaluation.detection[2];
  EXPECT_EQ(of_curves.method, curve_detection_method);
  ASSERT_EQ(of_curves.counts.size(), 75U);
  EXPECT_GT(of_curves.counts[30].detections(Metric::planes).recall(), 0.0);
  for (std::size_t k = 0; k < 75; k += 5) {
    EXPECT_GE(of_curves.counts[k].detections(Metric::planes).found,
              of_curves.counts[k + 4].detections(Metric::planes).found);
  }
  EXPECT_EQ(evaluation.objects.size(), scene.truth.objects.size());
  const ThreadLimit one(1);
  EXPECT_EQ(timeless(evaluate_scene(scene.scene, scene.truth, options)), timeless(evaluation));
}

TEST(CountResult, CountsNoSymmetriesIfTheGroundTruthHasMasksOnly) {
  const Scene scene = three_points();
  SegmentationResult result;
  result.cloud = scene.cloud;
  result.objects.resize(1);
  result.objects.front().points = {0, 1};
  result.objects.front().reflectional.emplace_back();
  SceneTruth truth = cups_of({{0, 1}, {2}});
  const SettingCounts counts = count_result(scene, truth, result);
  EXPECT_EQ(counts.detections(Metric::masks_90).correct, 1U);
  EXPECT_EQ(counts.detections(Metric::planes).found, 0U);
  truth.objects.front().rotational.emplace_back();
  EXPECT_EQ(count_result(scene, truth, result).detections(Metric::axes).ground_truth, 1U);
}

TEST(CountResult, LeavesOutBoundariesOfScenesWithoutAny) {
  Scene scene = three_points();
  scene.cloud.positions *= 0.005F;  // neighbours
  SegmentationResult result;
  result.cloud = scene.cloud;
  result.objects.resize(1);
  result.objects.front().points = {0, 1, 2};
  SettingCounts counts = count_result(scene, cups_of({{0, 1, 2}}), result);
  EXPECT_FALSE(counts.points.has_boundary());
  result.objects.front().points = {0, 1};
  result.objects.emplace_back().points = {2};
  counts += count_result(scene, cups_of({{0, 1}, {2}}), result);
  EXPECT_DOUBLE_EQ(counts.points.mean(2).boundary_f, 1.0);
}

TEST(EvaluateScene, CountsObjectsOfWhichTheSceneHasNoPoint) {
  EvaluationOptions options;
  options.baselines = {everything};
  const CameraIntrinsics camera{4, 2, 5, 5, 1.5, 0.5};
  const std::vector<float> depth(8, 1.0F);
  const std::vector<std::uint16_t> labels{1, 1, 0, 0, 2, 2, 0, 0};
  const SceneEvaluation lost =
      evaluate_scene(Scene{}, cups_of({{}, {}}), options, {}, LabeledView{camera, depth, labels});
  ASSERT_EQ(lost.objects.size(), 2U);
  EXPECT_EQ(lost.objects[1].outcome, Outcome::lost);
  for (const Sweep& sweep : lost.segmentation) {
    const SettingCounts& counts = sweep.at_default ? *sweep.at_default : sweep.counts[0];
    EXPECT_EQ(counts.detections(Metric::masks_75).ground_truth, 2U) << sweep.method;
    EXPECT_EQ(counts.detections(Metric::masks_75).recall(), 0.0) << sweep.method;
    EXPECT_EQ(counts.images, 1U) << sweep.method;
    EXPECT_EQ(counts.pixels.overlap_recall, 0.0) << sweep.method;
  }
  Evaluation evaluation;
  evaluation.add(lost);
  EXPECT_EQ(evaluation.outcomes.count(Outcome::lost), 2U);
  EXPECT_EQ(evaluation.small_objects.objects, 2U);
  EXPECT_NE(missed_object_text(evaluation).find("fewer than 100 points at 5 mm        2"),
            std::string::npos)
      << missed_object_text(evaluation);
  EXPECT_NE(pixels_csv(evaluation).find("everything,,share=0,1,1.000000,0.000000,0.000000"),
            std::string::npos)
      << pixels_csv(evaluation);
}

TEST(EvaluateScene, AcceptsAnEmptyScene) {
  EvaluationOptions options;
  options.baselines = {everything};
  const SceneEvaluation evaluation = evaluate_scene(Scene{}, SceneTruth{}, options);
  EXPECT_EQ(evaluation.returned, 0U);
  EXPECT_EQ(evaluation.segmentation.size(), 5U);
}

TEST(EvaluateScene, RefusesABaselineWithAnotherNumberOfMasksThanValues) {
  EvaluationOptions options;
  options.baselines = {[](const PointCloud&) { return BaselineSweep{"odd", "k", {1.0}, {}}; }};
  EXPECT_THROW(evaluate_scene(Scene{}, SceneTruth{}, options), InputError);
  options.boundary_radius = 0.0;
  EXPECT_THROW(evaluate_scene(Scene{}, SceneTruth{}, options), InputError);
}

}  // namespace
}  // namespace symscene
