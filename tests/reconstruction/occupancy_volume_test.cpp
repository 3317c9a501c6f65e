#include "symscene/reconstruction/occupancy_volume.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <optional>
#include <random>

#ifdef SYMSCENE_WITH_OCTOMAP
#include <octomap/OcTree.h>
#endif

#include "core/octree.hpp"
#include "reconstruction/analytic_scenes.hpp"
#include "symscene/core/error.hpp"
#include "symscene/occupancy/occupancy_grid.hpp"
#include "symscene/simulation/simulation.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

const CameraIntrinsics voxel_camera{160, 120, 130.0, 131.0, 79.3, 59.8};

Eigen::Isometry3d pose_of(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::array<double, 4> q{};
  for (double& value : q) value = uniform(random);  // in this order, whatever the compiler
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
  pose.translation() << uniform(random), uniform(random), uniform(random);
  return pose;
}

/// Tilted patches at random depths, holes and speckle, and every kind of bad value.
DepthFrame rough_frame(std::mt19937& random) {
  DepthFrame frame = testing::flat_frame(voxel_camera, 0.0F);
  std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
  constexpr Index patch = 20;
  std::vector<float> bases((voxel_camera.width / patch + 1) * (voxel_camera.height / patch + 1));
  for (float& base : bases) base = uniform(random) < 0.2F ? 0.0F : 0.3F + 1.5F * uniform(random);
  for (Index v = 0; v < voxel_camera.height; ++v) {
    for (Index u = 0; u < voxel_camera.width; ++u) {
      const float base = bases[(v / patch) * (voxel_camera.width / patch + 1) + u / patch];
      float& depth = frame.depth[std::size_t{v} * voxel_camera.width + u];
      if (base > 0.0F)
        depth = base + 0.004F * static_cast<float>(u % patch) + 0.002F * uniform(random);
      if (uniform(random) < 0.01F) depth = 0.0F;
    }
  }
  const float bad[] = {std::numeric_limits<float>::quiet_NaN(), -1.0F, 1e30F, 1e-30F,
                       std::numeric_limits<float>::infinity(),  0.001F};
  for (const float value : bad) {
    for (int k = 0; k < 5; ++k) frame.depth[random() % voxel_camera.pixels()] = value;
  }
  return frame;
}

bool same_leaves(const OccupancyMap& a, const OccupancyMap& b) {
  return std::equal(a.leaves.begin(), a.leaves.end(), b.leaves.begin(), b.leaves.end(),
                    [](const OccupancyLeaf& x, const OccupancyLeaf& y) {
                      return x.key == y.key && x.level == y.level && x.state == y.state;
                    });
}

bool same_leaves(const LogOddsMap& a, const LogOddsMap& b) {
  return std::equal(a.leaves.begin(), a.leaves.end(), b.leaves.begin(), b.leaves.end(),
                    [](const LogOddsLeaf& x, const LogOddsLeaf& y) {
                      return x.key == y.key && x.level == y.level && x.log_odds == y.log_odds;
                    });
}

bool measured(float depth) { return depth > 0.0F && std::isfinite(depth); }

/// The definition, voxel by voxel in double: +1 looked through, 0 not, and nothing where rounding
/// decides.
std::optional<bool> looked_through(const DepthFrame& frame, const Eigen::Isometry3d& T_world_camera,
                                   const Eigen::Vector3d& center, const OccupancyVolumeOptions& o) {
  const Eigen::Vector3d p = T_world_camera.inverse() * center;
  if (p.z() < 1e-4) return p.z() < 0.0 ? std::optional(false) : std::nullopt;
  const Eigen::Vector2d at = voxel_camera.project(p);
  const Eigen::Vector2d from_edge = (at.array() + 0.5 - (at.array() + 0.5).round()).abs();
  if (from_edge.minCoeff() < 1e-3 || at.cwiseAbs().maxCoeff() > 1e6) {
    return at.cwiseAbs().maxCoeff() > 1e4 ? std::optional(false) : std::nullopt;
  }
  const auto u = static_cast<int>(std::lround(at.x()));
  const auto v = static_cast<int>(std::lround(at.y()));
  if (u < 1 || v < 1 || u > static_cast<int>(voxel_camera.width) - 2 ||
      v > static_cast<int>(voxel_camera.height) - 2) {
    return false;
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (int y = v - 1; y <= v + 1; ++y) {
    for (int x = u - 1; x <= u + 1; ++x) {
      const float depth = frame.depth[static_cast<std::size_t>(y) * voxel_camera.width +
                                      static_cast<std::size_t>(x)];
      if (measured(depth)) nearest = std::min(nearest, double{depth});
    }
  }
  if (std::isinf(nearest)) return false;
  const double limit = std::min(nearest - o.free_margin, o.max_depth);
  if (std::abs(p.z() - limit) < 2e-5) return std::nullopt;
  return p.z() < limit;
}

/// Voxels of a box, with their state and their centre.
template <class Visit>
void for_each_voxel(const OccupancyGrid& grid, const Visit& visit) {
  std::size_t i = 0;
  for (int z = 0; z < grid.frame.size.z(); ++z) {
    for (int y = 0; y < grid.frame.size.y(); ++y) {
      for (int x = 0; x < grid.frame.size.x(); ++x, ++i) {
        const Eigen::Vector3d cell(x + 0.5, y + 0.5, z + 0.5);
        visit(grid.states[i], Eigen::Vector3d(grid.frame.origin.cast<double>() +
                                              cell * static_cast<double>(grid.frame.resolution)));
      }
    }
  }
}

OccupancyVolumeOptions coarse() {
  OccupancyVolumeOptions options;
  options.resolution = 0.01;
  options.max_depth = 2.0;
  return options;
}

TEST(OccupancyVolume, BoundsOfCubesAgreeWithEveryVoxel) {
#ifdef SYMSCENE_SANITIZED
  constexpr unsigned seeds = 1;
  constexpr float reach = 0.6F;
#else
  constexpr unsigned seeds = 4;
  constexpr float reach = 1.3F;
#endif
  for (unsigned seed = 0; seed < seeds; ++seed) {
    std::mt19937 random(seed);
    const OccupancyVolumeOptions options = coarse();
    OccupancyVolume volume(options);
    const DepthFrame frame = rough_frame(random);
    const Eigen::Isometry3d pose = pose_of(random);
    volume.integrate(frame, voxel_camera, pose);
    const Eigen::Vector3f middle = (pose * Eigen::Vector3d(0, 0, 0.9)).cast<float>();
    const OccupancyGrid grid =
        rasterize(volume.map(), Box{middle.array() - reach, middle.array() + reach});
    std::size_t compared = 0;
    std::size_t wrong = 0;
    std::size_t free = 0;
    for_each_voxel(grid, [&](VoxelState state, const Eigen::Vector3d& center) {
      const auto expected = looked_through(frame, pose, center, options);
      if (!expected || state == VoxelState::occupied) return;
      ++compared;
      free += *expected ? 1 : 0;
      wrong += (state == VoxelState::free) != *expected ? 1 : 0;
    });
    EXPECT_EQ(wrong, 0U) << "seed " << seed;
    EXPECT_GT(free, 10000U);
    EXPECT_GT(compared, 9 * grid.states.size() / 10);
  }
}

TEST(OccupancyVolume, ExactlyTheVoxelsWithAMeasuredPointAreOccupied) {
  std::mt19937 random(7);
  const OccupancyVolumeOptions options = coarse();
  OccupancyVolume volume(options);
  const DepthFrame frame = rough_frame(random);
  const Eigen::Isometry3d pose = pose_of(random);
  volume.integrate(frame, voxel_camera, pose);
  std::size_t points = 0;
  std::size_t missed = 0;
  for (Index v = 0; v < voxel_camera.height; ++v) {
    for (Index u = 0; u < voxel_camera.width; ++u) {
      const float depth = frame.depth[std::size_t{v} * voxel_camera.width + u];
      if (!measured(depth) || depth > options.max_depth) continue;
      const Eigen::Vector3d p = pose * (depth * voxel_camera.ray(u, v));
      const Eigen::Array3d cell = p.array() / options.resolution;
      if ((cell - cell.round()).abs().minCoeff() < 1e-3) continue;
      ++points;
      missed += volume.at(p) != VoxelState::occupied ? 1 : 0;
    }
  }
  EXPECT_GT(points, 5000U);
  EXPECT_EQ(missed, 0U);
  std::size_t occupied = 0;
  for (const OccupancyLeaf& leaf : volume.map().leaves) {
    if (leaf.state == VoxelState::occupied) occupied += voxels_of(leaf.level);
  }
  EXPECT_LE(occupied, voxel_camera.pixels());
}

TEST(OccupancyVolume, SpaceIsFreeInFrontOfAWallOccupiedOnItAndNeverSeenBehind) {
  OccupancyVolume volume;
  for (int i = 0; i < 3; ++i) {
    volume.integrate(testing::flat_frame(voxel_camera, 1.002F), voxel_camera,
                     Eigen::Isometry3d::Identity());
  }
  for (double x = -0.4; x < 0.4; x += 0.0131) {
    for (double z = 0.85; z < 0.99; z += 0.0171) {
      EXPECT_EQ(volume.at({x, 0.1, z}), VoxelState::free);
    }
    for (double z = 1.006; z < 1.5; z += 0.0171) {
      EXPECT_EQ(volume.at({x, 0.1, z}), VoxelState::never_seen);
    }
    EXPECT_NE(volume.at({x, 0.1, 1.002}), VoxelState::free);
  }
  EXPECT_EQ(volume.at(1.002 * voxel_camera.ray(80, 60)), VoxelState::occupied);
  EXPECT_EQ(volume.at({0.0, 0.0, -0.1}), VoxelState::never_seen);
  EXPECT_EQ(volume.at({1.0, 0.0, 0.5}), VoxelState::never_seen);
}

TEST(OccupancyVolume, SpaceIsFreeUpToTheLargestDepth) {
  OccupancyVolumeOptions options;
  options.max_depth = 1.5;
  OccupancyVolume volume(options);
  volume.integrate(testing::flat_frame(voxel_camera, 20.0F), voxel_camera,
                   Eigen::Isometry3d::Identity());
  EXPECT_EQ(volume.at({0, 0, 1.49}), VoxelState::free);
  EXPECT_EQ(volume.at({0, 0, 1.51}), VoxelState::never_seen);
}

TEST(OccupancyVolume, PixelsWithoutAMeasurementAreIgnored) {
  const float bad[] = {0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN(),
                       std::numeric_limits<float>::infinity()};
  for (const float depth : bad) {
    OccupancyVolume volume;
    volume.integrate(testing::flat_frame(voxel_camera, depth), voxel_camera,
                     Eigen::Isometry3d::Identity());
    EXPECT_TRUE(volume.map().leaves.empty()) << depth;
  }
}

/// A wall at 1 m with independent noise of 3 mm, worse than the sensor's.
DepthFrame noisy_wall(std::mt19937& random) {
  std::normal_distribution<float> noise(0.0F, 0.003F);
  DepthFrame frame = testing::flat_frame(voxel_camera, 1.0025F);
  for (float& depth : frame.depth) depth += noise(random);
  return frame;
}

TEST(OccupancyVolume, NoiseDoesNotCarveASurface) {
  std::mt19937 random(5);
  OccupancyVolume volume;
  for (int i = 0; i < 30; ++i) {
    volume.integrate(noisy_wall(random), voxel_camera, Eigen::Isometry3d::Identity());
  }
  int carved = 0;
  for (double x = -0.4; x < 0.4; x += 0.005) {
    for (double y = -0.3; y < 0.3; y += 0.005) {
      carved += volume.at({x + 0.0025, y + 0.0025, 1.0025}) == VoxelState::free ? 1 : 0;
    }
  }
  EXPECT_EQ(carved, 0);
}

TEST(OccupancyVolume, RemovedObjectsAreForgotten) {
  OccupancyVolume volume;
  const Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 50; ++i)
    volume.integrate(testing::flat_frame(voxel_camera, 0.6F), voxel_camera, pose);
  EXPECT_EQ(volume.at({0, 0, 0.601}), VoxelState::occupied);
  for (int i = 0; i < 10; ++i)
    volume.integrate(testing::flat_frame(voxel_camera, 1.0F), voxel_camera, pose);
  EXPECT_EQ(volume.at({0, 0, 0.601}), VoxelState::free);
}

TEST(OccupancyVolume, AHoleOfOnePixelDoesNotHideASurface) {
  DepthFrame frame = testing::flat_frame(voxel_camera, 1.0F);
  for (std::size_t i = 0; i < frame.depth.size(); i += 7) frame.depth[i] = 0.0F;
  OccupancyVolume volume;
  volume.integrate(frame, voxel_camera, Eigen::Isometry3d::Identity());
  for (double z = 0.2; z < 0.99; z += 0.01) {
    EXPECT_EQ(volume.at({0.0, 0.0, z}), VoxelState::free) << z;
  }
}

TEST(OccupancyVolume, RepeatedFramesTakeNoMoreMemoryThanOne) {
  std::mt19937 random(9);
  OccupancyVolume volume;
  for (int i = 0; i < 5; ++i) {
    volume.integrate(noisy_wall(random), voxel_camera, Eigen::Isometry3d::Identity());
  }
  const std::size_t before = volume.memory();
  for (int i = 0; i < 50; ++i) {
    volume.integrate(noisy_wall(random), voxel_camera, Eigen::Isometry3d::Identity());
  }
  EXPECT_LT(static_cast<double>(volume.memory()), 1.2 * static_cast<double>(before));
  EXPECT_LT(before, 8U << 20U);
}

OccupancyVolume rough_volume(unsigned seed) {
  std::mt19937 random(seed);
  OccupancyVolume volume(coarse());
  for (int i = 0; i < 5; ++i) volume.integrate(rough_frame(random), voxel_camera, pose_of(random));
  return volume;
}

TEST(OccupancyVolume, ThreadsDoNotChangeTheResult) {
  const auto run = [] { return rough_volume(3).log_odds(); };
  const LogOddsMap one = testing::with_threads(1, run);
  EXPECT_GT(one.leaves.size(), 1000U);
  EXPECT_TRUE(same_leaves(testing::with_threads(2, run), one));
  EXPECT_TRUE(same_leaves(testing::with_threads(4, run), one));
}

TEST(OccupancyVolume, LabelsOfLogOddsAreTheMap) {
  const OccupancyVolume volume = rough_volume(4);
  EXPECT_TRUE(same_leaves(labels(volume.log_odds()), volume.map()));
}

TEST(OccupancyVolume, TheMapAgreesWithLookUpsOfPoints) {
  const OccupancyVolume volume = rough_volume(6);
  const OccupancyMap map = volume.map();
  const OccupancyGrid grid =
      rasterize(map, Box{Eigen::Vector3f::Constant(-1.0F), Eigen::Vector3f::Constant(1.0F)});
  std::size_t wrong = 0;
  for_each_voxel(grid, [&](VoxelState state, const Eigen::Vector3d& center) {
    wrong += volume.at(center) != state ? 1 : 0;
  });
  EXPECT_EQ(wrong, 0U);
}

TEST(OccupancyVolume, ARegionHoldsTheVoxelsWhoseCentresAreInIt) {
  std::mt19937 random(8);
  const OccupancyVolume volume = rough_volume(8);
  OrientedBox region;
  region.T_world_box.linear() = pose_of(random).linear();
  region.min = {-0.4, -0.3, -0.5};
  region.max = {0.3, 0.4, 0.2};
  const Box box{Eigen::Vector3f::Constant(-0.8F), Eigen::Vector3f::Constant(0.8F)};
  const OccupancyGrid all = rasterize(volume.map(), box);
  const OccupancyGrid inside = rasterize(volume.map(region), box);
  const Eigen::Isometry3d T_box_world = region.T_world_box.inverse();
  std::size_t kept = 0;
  std::size_t wrong = 0;
  std::size_t i = 0;
  for_each_voxel(all, [&](VoxelState state, const Eigen::Vector3d& center) {
    const Eigen::Vector3d p = T_box_world * center;
    const double depth = (p - region.min).cwiseMin(region.max - p).minCoeff();
    const VoxelState expected = depth > 0.0 ? state : VoxelState::never_seen;
    kept += expected != VoxelState::never_seen ? 1 : 0;
    wrong += std::abs(depth) > 1e-6 && inside.states[i] != expected ? 1 : 0;
    ++i;
  });
  EXPECT_GT(kept, 1000U);
  EXPECT_EQ(wrong, 0U);
}

TEST(OccupancyVolume, ResultsDoNotDependOnTheDistanceFromTheOrigin) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << 120.0, -90.0, 60.0;
  OccupancyVolume volume;
  volume.integrate(testing::flat_frame(voxel_camera, 1.002F), voxel_camera, pose);
  EXPECT_EQ(volume.at({120.0, -90.0, 60.9}), VoxelState::free);
  EXPECT_EQ(volume.at(pose * (1.002 * voxel_camera.ray(80, 60))), VoxelState::occupied);
}

TEST(OccupancyVolume, PointsOutsideTheTreeAreIgnored) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation().x() = 163.5;  // the tree ends at 163.84 m
  OccupancyVolume volume;
  volume.integrate(testing::flat_frame(voxel_camera, 1.0F), voxel_camera, pose);
  EXPECT_EQ(volume.at({163.5, 0, 0.9}), VoxelState::free);
  pose.translation().x() = 90000.0;
  OccupancyVolume far;
  far.integrate(testing::flat_frame(voxel_camera, 1.0F), voxel_camera, pose);
  EXPECT_TRUE(far.map().leaves.empty());
}

TEST(OccupancyVolume, UnusableFramesAreRefused) {
  OccupancyVolume volume;
  const Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  EXPECT_THROW(volume.integrate({}, voxel_camera, pose), InputError);
  EXPECT_THROW(volume.integrate({}, {}, pose), InputError);
  CameraIntrinsics bad = voxel_camera;
  bad.fx = 0.0;
  EXPECT_THROW(volume.integrate(testing::flat_frame(voxel_camera, 1.0F), bad, pose), InputError);
  bad = voxel_camera;
  bad.cy = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(volume.integrate(testing::flat_frame(voxel_camera, 1.0F), bad, pose), InputError);
  Eigen::Isometry3d crooked = pose;
  crooked.linear() *= 2.0;
  EXPECT_THROW(volume.integrate(testing::flat_frame(voxel_camera, 1.0F), voxel_camera, crooked),
               InputError);
  crooked = pose;
  crooked.translation().x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(volume.integrate(testing::flat_frame(voxel_camera, 1.0F), voxel_camera, crooked),
               InputError);
}

TEST(OccupancyVolume, TinyImagesAreAccepted) {
  for (Index width = 1; width <= 5; ++width) {
    for (Index height = 1; height <= 4; ++height) {
      const CameraIntrinsics tiny{width, height, 2.0, 2.0, 0.5 * (width - 1), 0.5 * (height - 1)};
      OccupancyVolume volume;
      volume.integrate({0.0, std::vector<float>(tiny.pixels(), 0.5F), {}}, tiny,
                       Eigen::Isometry3d::Identity());
      EXPECT_FALSE(volume.map().leaves.empty());
    }
  }
}

TEST(OccupancyVolumeOptions, InvalidValuesAreRefused) {
  const auto refused = [](auto&& change) {
    OccupancyVolumeOptions options;
    change(options);
    EXPECT_THROW(options.validate(), InputError);
  };
  refused([](auto& o) { o.resolution = 0.0; });
  refused([](auto& o) { o.max_depth = 1e9; });
  refused([](auto& o) { o.hit = -1.0; });
  refused([](auto& o) { o.miss = 0.0; });
  refused([](auto& o) { o.max_log_odds = 100.0; });
  refused([](auto& o) { o.threshold = std::numeric_limits<double>::quiet_NaN(); });
}

#ifdef SYMSCENE_WITH_OCTOMAP
/// A scan of a table in small images: OctoMap takes seconds for a large one.
TEST(OccupancyVolume, AgreesWithOctoMapsInsertion) {
  SimulationOptions scan;
  scan.camera.frames = 3;
  scan.camera.width = 160;
  scan.camera.height = 120;
  scan.camera.focal_length = 131.0;
  OccupancyVolumeOptions options;
  options.resolution = 0.02;
  options.free_margin = 0.02;
  OccupancyVolume volume(options);
  octomap::OcTree tree(options.resolution);
  const CameraIntrinsics small = scan.camera.intrinsics();
  for (const SensorFrame& frame : capture_frames(arrange_tabletop(scan.tabletop), scan)) {
    volume.integrate({0.0, frame.depth, {}}, small, frame.T_world_camera);
    octomap::Pointcloud points;
    for (Index v = 0; v < small.height; ++v) {
      for (Index u = 0; u < small.width; ++u) {
        const double depth = frame.depth[std::size_t{v} * small.width + u];
        const Eigen::Vector3f p = (frame.T_world_camera * (depth * small.ray(u, v))).cast<float>();
        if (depth > 0.0) points.push_back(p.x(), p.y(), p.z());
      }
    }
    const Eigen::Vector3f origin = frame.T_world_camera.translation().cast<float>();
    tree.insertPointCloud(points, {origin.x(), origin.y(), origin.z()}, options.max_depth);
  }
  const Box box{Eigen::Vector3f::Constant(-0.5F), Eigen::Vector3f::Constant(0.7F)};
  const OccupancyGrid grid = rasterize(volume.map(), box);
  std::size_t equal = 0;
  std::size_t contradict = 0;
  std::size_t occupied = 0;
  for_each_voxel(grid, [&](VoxelState state, const Eigen::Vector3d& center) {
    const octomap::OcTreeNode* node = tree.search(center.x(), center.y(), center.z());
    const VoxelState theirs = node == nullptr             ? VoxelState::never_seen
                              : tree.isNodeOccupied(node) ? VoxelState::occupied
                                                          : VoxelState::free;
    equal += theirs == state ? 1 : 0;
    occupied += theirs == VoxelState::occupied ? 1 : 0;
    contradict +=
        theirs != state && theirs != VoxelState::never_seen && state != VoxelState::never_seen ? 1
                                                                                               : 0;
  });
  EXPECT_GT(static_cast<double>(equal), 0.97 * static_cast<double>(grid.states.size()));
  EXPECT_LT(static_cast<double>(contradict), 0.05 * static_cast<double>(occupied));
}
#endif

}  // namespace
}  // namespace symscene
