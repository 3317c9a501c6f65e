// A real scene of ten objects, where the data is there.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include <fmt/ranges.h>

#include "core/random.hpp"
#include "surfaces.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/pipeline/pipeline.hpp"

namespace symscene {
namespace {

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
