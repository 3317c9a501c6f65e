// Collisions of swept hands against those of FCL: distances from samples of surfaces agree with
// distances from triangles up to the sampling bound, heights over the table exactly.
#ifdef SYMSCENE_HAS_FCL
#include "grasping/fcl_oracle.hpp"
#endif

#include <gtest/gtest.h>

#include <random>

#include "grasping/hand_collision.hpp"
#include "grasping/random_scenes.hpp"
#include "grasping/unknown_space.hpp"

namespace symscene {
namespace {

#ifdef SYMSCENE_HAS_FCL

using testing::between_of;
using testing::fcl_collides;
using testing::fcl_distance;
using testing::FclGeometry;
using testing::random_gripper;
using testing::sample_offset;
using testing::sampling_bound;

constexpr std::array<GripperKind, 2> kinds{GripperKind::parallel, GripperKind::three_finger};

/// A scene for the planner and for FCL.
struct OracleScene {
  GraspScene scene;
  std::vector<SurfaceSamples> samples;
  std::vector<FclGeometry> meshes;
  FclGeometry table = std::make_shared<fcl::Halfspaced>(Eigen::Vector3d::UnitZ(), 0.0);

  explicit OracleScene(std::mt19937& random) : scene(testing::random_scene(random)) {
    for (const GraspObject& object : scene.objects) {
      samples.push_back(surface_samples(object.surface));
      meshes.push_back(testing::fcl_mesh(object.surface.mesh));
    }
  }
};

/// A pose at which a point in one of the boxes is near a sample of a surface.
Eigen::Isometry3d pose_near(const SurfaceSamples& samples, const std::vector<HandBox>& boxes,
                            std::mt19937& random) {
  const auto any = [&](double reach) { return between_of(random, -reach, reach); };
  const HandBox& box =
      boxes[std::uniform_int_distribution<std::size_t>(0, boxes.size() - 1)(random)];
  const Eigen::Vector3d in_box =
      box.centre.cast<double>() +
      Eigen::Vector3d(any(1.0), any(1.0), any(1.0)).cwiseProduct(box.half.cast<double>());
  const auto at = std::uniform_int_distribution<Eigen::Index>(0, samples.size() - 1)(random);
  const Eigen::Vector3d target = samples.positions.row(at).transpose().cast<double>() +
                                 Eigen::Vector3d(any(0.06), any(0.06), any(0.06));
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = testing::random_rotation(random);
  pose.translation() = target - pose.linear() * in_box;
  return pose;
}

/// Calls check(scene, gripper's swept boxes, pose) for many random ones.
template <class Check>
void for_random_hands(unsigned seed, int poses, const Check& check) {
  std::mt19937 random(seed);
  for (int trial = 0; trial < 3; ++trial) {
    const OracleScene scene(random);
    for (const GripperKind kind : kinds) {
      const std::vector<HandBox> boxes = testing::swept_boxes(random_gripper(random, kind));
      for (int i = 0; i < poses; ++i) {
        const std::size_t near = static_cast<std::size_t>(i) % scene.samples.size();
        check(scene, boxes, pose_near(scene.samples[near], boxes, random));
      }
    }
  }
}

TEST(HandCollisionAgainstFcl, IsTheDistanceFromTheMeshUpToTheSamplingBound) {
  constexpr DistanceBounds bounds{0.03F, -1.0F};
  int free = 0;
  int met = 0;
  for_random_hands(1, 15, [&](const OracleScene& scene, const auto& boxes, const auto& pose) {
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
      const double ours = static_cast<double>(
          least_distance(scene.samples[i], pose.inverse().template cast<float>(), boxes, bounds));
      const double oracle = fcl_distance(scene.meshes[i], pose, boxes);
      const double clamped = std::min(oracle, 0.03);
      EXPECT_LE(std::max(ours, 0.0), clamped + sampling_bound);
      EXPECT_GE(std::max(ours, 0.0), clamped - sample_offset);
      // A sample deeper inside than it may lie off the surface is one of a triangle that is met.
      EXPECT_TRUE(ours >= -sample_offset || oracle == 0.0) << ours << " " << oracle;
      ++(oracle > 0.0 ? free : met);
    }
  });
  EXPECT_GT(free, 100);
  EXPECT_GT(met, 100);
}

/// A hand that the planner lets pass, which keeps a clearance from the samples, enters the mesh
/// less than the sampling bound exceeds the clearance.
TEST(HandCollisionAgainstFcl, FindsNoWayFreeThatEntersAMeshBeyondTheBound) {
  const auto clearance = static_cast<float>(GraspBoundOptions{}.object_clearance);
  const double deepest = sampling_bound - static_cast<double>(clearance);
  int free = 0;
  for_random_hands(2, 30, [&](const OracleScene& scene, const auto& boxes, const auto& pose) {
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
      const float ours = least_distance(scene.samples[i], pose.inverse().template cast<float>(),
                                        boxes, {0.03F, clearance});
      if (ours < clearance) continue;
      EXPECT_FALSE(fcl_collides(scene.meshes[i], pose, boxes, deepest));
      ++free;
    }
  });
  EXPECT_GT(free, 100);
}

TEST(HandCollisionAgainstFcl, HasTheHeightOverTheTable) {
  int above = 0;
  int below = 0;
  for_random_hands(3, 30, [&](const OracleScene& scene, const auto& boxes, const auto& pose) {
    const double height = height_over(*scene.scene.table, pose, boxes);
    constexpr double rounding = 1e-6;
    if (std::abs(height) < rounding) return;
    EXPECT_EQ(fcl_collides(scene.table, pose, boxes, 0.0), height < 0.0) << height;
    ++(height > 0.0 ? above : below);
  });
  EXPECT_GT(above, 20);
  EXPECT_GT(below, 20);
}

/// Free space around the origin in which one cuboid of voxels was never seen.
struct HiddenCuboid {
  OccupancyGrid grid;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  // [m]

  explicit HiddenCuboid(std::mt19937& random) {
    grid.frame = {Eigen::Vector3f::Constant(-0.6F), 0.005F, Eigen::Vector3i::Constant(240)};
    grid.states.assign(grid.frame.voxels(), VoxelState::free);
    Eigen::Vector3i low;
    Eigen::Vector3i high;
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::uniform_int_distribution<int>(100, 120)(random);
      high[axis] = low[axis] + std::uniform_int_distribution<int>(4, 40)(random);
    }
    hide(low, high);
    centre = (0.5 * (low + high).cast<double>() * 0.005).array() - 0.6;
    size = (high - low).cast<double>() * 0.005;
  }
  void hide(const Eigen::Vector3i& low, const Eigen::Vector3i& high) {
    for (int z = low.z(); z < high.z(); ++z) {
      for (int y = low.y(); y < high.y(); ++y) {
        for (int x = low.x(); x < high.x(); ++x) {
          grid.states[static_cast<std::size_t>(z) * grid.frame.slice_length() +
                      static_cast<std::size_t>(y) * grid.frame.row_length() +
                      static_cast<std::size_t>(x)] = VoxelState::never_seen;
        }
      }
    }
  }
  /// Whether boxes of a hand enter the cuboid without a border of that width. [m]
  bool is_entered(const Eigen::Isometry3d& T_world_tool, std::span<const HandBox> boxes,
                  double border) const {
    const HandBox inner = HandBox::between(centre.array() - size.array() / 2.0 + border,
                                           centre.array() + size.array() / 2.0 - border);
    if (inner.half.minCoeff() <= 0.0F) return false;
    const Eigen::Vector3d edges = 2.0 * inner.half.cast<double>();
    auto cuboid = std::make_shared<fcl::Boxd>(edges);
    const Eigen::Isometry3d T_cuboid_tool =
        Eigen::Translation3d(-inner.centre.cast<double>()) * T_world_tool;
    return fcl_collides(cuboid, T_cuboid_tool, boxes, 0.0);
  }
};

/// A hand is looked up in never-seen space at points that leave no gap beyond half the diagonal of
/// their spacing.
TEST(HandCollisionAgainstFcl, MeetsNeverSeenSpaceUpToTheSpacingOfTheHandsPoints) {
  constexpr float spacing = 0.012F;
  const double gap = 0.5 * std::sqrt(3.0) * static_cast<double>(spacing);
  std::mt19937 random(4);
  int outside = 0;
  int inside = 0;
  for (int trial = 0; trial < 4; ++trial) {
    const HiddenCuboid hidden(random);
    const UnknownSpace unknown(hidden.grid, {}, {}, 0.0F);
    const std::vector<HandBox> boxes =
        testing::swept_boxes(random_gripper(random, kinds[static_cast<std::size_t>(trial) % 2]));
    const Eigen::Matrix3Xf points = sample_boxes(boxes, spacing);
    for (int i = 0; i < 60; ++i) {
      Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
      pose.linear() = testing::random_rotation(random);
      for (int axis = 0; axis < 3; ++axis)
        pose.translation()[axis] = hidden.centre[axis] + between_of(random, -0.15, 0.15);
      bool is_blocked = false;
      for (Eigen::Index k = 0; k < points.cols(); ++k)
        is_blocked |= unknown.blocks(pose.cast<float>() * Eigen::Vector3f(points.col(k)), 0);
      EXPECT_TRUE(is_blocked || !hidden.is_entered(pose, boxes, gap));
      EXPECT_TRUE(!is_blocked || hidden.is_entered(pose, boxes, -1e-5));
      ++(is_blocked ? inside : outside);
    }
  }
  EXPECT_GT(outside, 20);
  EXPECT_GT(inside, 20);
}

#else

TEST(HandCollisionAgainstFcl, IsSkippedWithoutFcl) {
  GTEST_SKIP() << "libfcl-dev is not installed";
}

#endif

}  // namespace
}  // namespace symscene
