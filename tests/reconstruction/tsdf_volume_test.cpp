#include "reconstruction/tsdf_volume.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "reconstruction/analytic_scenes.hpp"
#include "symscene/core/error.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

/// A wall at z = 0.8, seen straight on and tilted.
TsdfVolume wall_volume(double tilt, int frames = 1, const TsdfOptions& options = {}) {
  TsdfVolume volume(options);
  const Bodies wall{plane(-Eigen::Vector3d::UnitZ(), 0.8)};
  for (int k = 0; k < frames; ++k) {
    fuse(volume, wall, small_camera(), motion({tilt, 0, 0}, {0, 0, 0}));
  }
  return volume;
}

TEST(TsdfVolume, HoldsTheSignedDistanceOfAPlane) {
  for (const double tilt : {0.0, 0.3, 0.7}) {
    const TsdfVolume volume = wall_volume(tilt);
    int compared = 0;
    for_each_seen_voxel(volume, [&](const Eigen::Vector3d& p, double distance, double) {
      const double truth = 0.8 - p.z();
      if (std::abs(truth) > 0.01) return;
      ++compared;
      // Voxels take the depth of the nearest pixel, up to half of one beside them.
      EXPECT_NEAR(distance, truth, 1e-4 + 0.006 * std::sin(tilt)) << tilt;
    });
    EXPECT_GT(compared, 30000) << tilt;
  }
}

TEST(TsdfVolume, IsTruncatedInFrontOfASurfaceAndUnseenBehindIt) {
  const TsdfOptions options;
  for_each_seen_voxel(wall_volume(0.0), [&](const Eigen::Vector3d& p, double distance, double) {
    EXPECT_LE(distance, options.truncation + 1e-5);
    EXPECT_GE(distance, -options.truncation - 1e-5);
    EXPECT_LT(p.z(), 0.8 + options.truncation + 1e-3);
    if (p.z() < 0.8 - options.truncation - 1e-3) {
      EXPECT_NEAR(distance, options.truncation, 1e-5);
    }
  });
}

TEST(TsdfVolume, TruncatesFarDepthsAtALargerDistance) {
  const auto deepest = [](double depth) {
    TsdfVolume volume;
    fuse(volume, {plane(-Eigen::Vector3d::UnitZ(), depth)}, small_camera(),
         Eigen::Isometry3d::Identity());
    double least = 0.0;
    for_each_seen_voxel(volume, [&](const Eigen::Vector3d&, double distance, double) {
      least = std::min(least, distance);
    });
    return -least;
  };
  const double share = TsdfOptions().zero_weight_behind;
  EXPECT_NEAR(deepest(1.0), share * 0.0125, 0.0031);
  // The weight of so far a pixel is the least there is: it is there or not.
  EXPECT_NEAR(deepest(2.5), 0.4375 * 3.0 * 1.425e-3 * 6.25, 0.0031);
  EXPECT_LE(deepest(2.9), 0.04);
}

TEST(TsdfVolume, GathersWeightByRangeAndAngleUpToABound) {
  const auto weight_at_middle = [](double depth, double tilt, int frames, double most) {
    TsdfOptions options;
    options.max_weight = most;
    TsdfVolume volume(options);
    const Bodies wall{plane(-Eigen::Vector3d::UnitZ(), depth)};
    const Eigen::Vector3d eye(0, -std::tan(tilt) * depth, 0);
    for (int k = 0; k < frames; ++k) {
      fuse(volume, wall, small_camera(), motion({-tilt, 0, 0}, eye));
    }
    double found = 0.0;
    for_each_seen_voxel(volume, [&](const Eigen::Vector3d& p, double, double weight) {
      if ((p - Eigen::Vector3d(0, 0, depth)).norm() < 0.004) found = weight;
    });
    return found;
  };
  EXPECT_NEAR(weight_at_middle(1.0, 0.0, 1, 200), 1.0, 0.07);
  EXPECT_NEAR(weight_at_middle(1.0, 0.0, 5, 200), 5.0, 0.4);
  EXPECT_NEAR(weight_at_middle(0.7, 0.0, 1, 200), std::pow(0.7, -4), 0.15);
  const double tilted = weight_at_middle(0.7, 0.6, 1, 200), depth = 0.7 / std::cos(0.6);
  EXPECT_NEAR(tilted, std::pow(std::cos(0.6), 2) * std::pow(depth, -4), 0.15);
  EXPECT_EQ(weight_at_middle(1.0, 0.0, 30, 3), 3.0);
}

TEST(TsdfVolume, AveragesFramesAndForgetsOldOnes) {
  TsdfOptions options;
  options.max_weight = 10;
  TsdfVolume volume(options);
  const auto add = [&](double depth, int frames) {
    for (int k = 0; k < frames; ++k) {
      fuse(volume, {plane(-Eigen::Vector3d::UnitZ(), depth)}, small_camera(),
           Eigen::Isometry3d::Identity());
    }
  };
  const auto expect_wall = [&](double z) {
    for_each_seen_voxel(volume, [&](const Eigen::Vector3d& p, double distance, double) {
      if (std::abs(p.z() - z) < 0.001 && p.head<2>().norm() < 0.2) {
        EXPECT_NEAR(distance, z - p.z(), 3e-4);
      }
    });
  };
  add(0.8, 3);
  add(0.804, 3);
  expect_wall(0.802);
  add(0.804, 60);
  expect_wall(0.804);
}

TEST(TsdfVolume, KeepsOneSideOfAThinWallWhenTheOtherIsSeenMore) {
  // A wall of 5 mm, seen often from the front and once from the back.
  TsdfVolume volume;
  const CameraIntrinsics camera = small_camera();
  const Eigen::Isometry3d front = Eigen::Isometry3d::Identity();
  const Eigen::Isometry3d back = motion({0, std::numbers::pi, 0}, {0, 0, 1.605});
  for (int k = 0; k < 30; ++k) fuse(volume, {plane(-Eigen::Vector3d::UnitZ(), 0.8)}, camera, front);
  fuse(volume, {plane(Eigen::Vector3d::UnitZ(), 0.805)}, camera, back);
  int behind = 0;
  for_each_seen_voxel(volume, [&](const Eigen::Vector3d& p, double distance, double) {
    if (p.head<2>().norm() > 0.2 || p.z() < 0.8085) return;
    ++behind;
    EXPECT_GT(distance, 0.0) << p.transpose();
  });
  EXPECT_GT(behind, 1000);
}

TEST(TsdfVolume, IgnoresPixelsWithoutAMeasurement) {
  for (const float depth : {0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity(), 1e30F, 1e-30F, 0.19F, 3.01F}) {
    TsdfVolume volume;
    const DepthFrame frame = flat_frame(small_camera(), depth);
    volume.integrate(prepare_measurement(frame, small_camera(), {}), Eigen::Isometry3d::Identity());
    EXPECT_TRUE(volume.empty()) << depth;
  }
}

TEST(TsdfVolume, IgnoresInvalidPixelsAmongValidOnes) {
  DepthFrame frame = flat_frame(small_camera(), 0.8F);
  const float bad[] = {0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN(), 1e30F, 2.9F};
  for (std::size_t i = 0; i < frame.depth.size(); i += 97) frame.depth[i] = bad[i % 5];
  TsdfVolume volume;
  volume.integrate(prepare_measurement(frame, small_camera(), {}), Eigen::Isometry3d::Identity());
  int compared = 0;
  for_each_seen_voxel(volume, [&](const Eigen::Vector3d& p, double distance, double) {
    if (std::abs(p.z() - 0.8) > 0.01) return;
    ++compared;
    EXPECT_NEAR(distance, 0.8 - p.z(), 2e-4);
  });
  EXPECT_GT(compared, 20000);
}

TEST(TsdfVolume, KeepsColoursNearTheSurfaceAndOnlyThere) {
  DepthFrame frame = flat_frame(small_camera(), 0.8F);
  paint(frame, 10, 200, 90);
  TsdfVolume volume;
  volume.integrate(prepare_measurement(frame, small_camera(), {}), Eigen::Isometry3d::Identity());
  int colored = 0;
  for (std::size_t slot = 0; slot < volume.index().size(); ++slot) {
    const ColorBlock* block = volume.colors(slot);
    if (block == nullptr) continue;
    const Eigen::Vector3i first = volume.index().blocks()[slot] * TsdfBlock::edge;
    for (int i = 0; i < TsdfBlock::voxels; ++i) {
      const auto& rgbw = block->rgbw[static_cast<std::size_t>(i)];
      if (rgbw[3] == 0) continue;
      ++colored;
      EXPECT_EQ(rgbw, (std::array<std::uint8_t, 4>{10, 200, 90, 1}));
      EXPECT_NEAR((first.z() + (i >> 6) + 0.5) * volume.voxel_size(), 0.8, 0.0063);
    }
  }
  EXPECT_GT(colored, 20000);
  TsdfOptions colorless;
  colorless.color = false;
  TsdfVolume grey(colorless);
  grey.integrate(prepare_measurement(frame, small_camera(), {}), Eigen::Isometry3d::Identity());
  EXPECT_EQ(grey.colors(0), nullptr);
  EXPECT_EQ(wall_volume(0.0).colors(0), nullptr);
}

/// Voxels of 10 cm reach over the camera and beside the image, where there is no colour to take.
TEST(TsdfVolume, UsesColoursOfMeasuredPixelsOnly) {
  DepthFrame frame = flat_frame(small_camera(), 0.5F);
  paint(frame, 255, 255, 255);
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    if (i % 160 < 80) continue;
    frame.depth[i] = 0.0F;
    frame.colors.row(static_cast<Eigen::Index>(i)).setZero();
  }
  TsdfOptions options;
  options.voxel_size = 0.1;
  options.truncation = 0.2;
  options.max_truncation = 0.3;
  TsdfVolume volume(options);
  const Measurement measurement = prepare_measurement(frame, small_camera(), {});
  for (int k = 0; k < 3; ++k) {
    volume.integrate(measurement, motion({0, 0, 0}, {0.03 * k, 0, 0}));
  }
  int colored = 0;
  for (std::size_t slot = 0; slot < volume.index().size(); ++slot) {
    if (volume.colors(slot) == nullptr) continue;
    for (const auto& rgbw : volume.colors(slot)->rgbw) {
      if (rgbw[3] == 0) continue;
      ++colored;
      EXPECT_EQ(rgbw[0], 255);
    }
  }
  EXPECT_GT(colored, 10);
}

/// The change of one voxel by one frame, in double precision.
struct ScalarVoxel {
  double distance = TsdfBlock::never_seen;  ///< [units]
  int weight = 0;
  bool decided = true;  ///< not by rounding
};

ScalarVoxel fuse_scalar(const ScalarVoxel& old, const Eigen::Vector3d& center,
                        const Measurement& measurement, const Eigen::Isometry3d& T_camera_world,
                        const TsdfVolume& volume) {
  const CameraIntrinsics& camera = measurement.camera;
  const Eigen::Vector3d p = T_camera_world * center;
  ScalarVoxel now = old;
  if (std::abs(p.z() - 0.01) < 1e-4) now.decided = false;
  if (p.z() < 0.01) return now;
  const Eigen::Vector2d at = camera.project(p).array() + 0.5;
  if ((at.array() - at.array().round()).abs().minCoeff() < 2e-3) now.decided = false;
  if (at.minCoeff() < 0 || at.x() >= camera.width || at.y() >= camera.height) return now;
  const auto pixel =
      static_cast<std::size_t>(at.y()) * camera.width + static_cast<std::size_t>(at.x());
  const std::uint32_t packed = measurement.packed[pixel];
  if (packed == 0) return now;
  const TsdfOptions& o = volume.options();
  const double depth = (packed >> 16) * 1e-4, cosine = (packed >> 8 & 255) / 255.0;
  const double cut =
      std::clamp(o.truncation_sigmas * 1.425e-3 * depth * depth, o.truncation, o.max_truncation);
  const double full = (depth - p.z()) * cosine;
  if (std::abs(full + cut) < 1e-5) now.decided = false;
  if (std::abs(p.z() - depth - cut) < 1e-5) now.decided = false;
  if (full <= -cut || p.z() - depth >= cut) return now;
  const double surface_weight = std::clamp((0.625 * cut + full) / (0.375 * cut), 0.0, 1.0);
  const double weighed = static_cast<double>(packed & 255) * surface_weight;
  // Rounding may go either way in float.
  if (std::abs(weighed - std::floor(weighed) - 0.5) < 0.1) now.decided = false;
  const int added = static_cast<int>(weighed + 0.5), sum = old.weight + added;
  if (sum == 0) return now;
  const double units = std::min(full, cut) / static_cast<double>(volume.distance_unit());
  now.distance = (old.distance * old.weight + units * added) / sum;
  now.weight = std::min(sum, static_cast<int>(16 * o.max_weight));
  return now;
}

/// Fuses frames into a volume, and into voxels of its blocks one at a time.
void expect_scalar_result(const TsdfOptions& options, const CameraIntrinsics& camera,
                          const std::vector<Eigen::Isometry3d>& poses, std::size_t least) {
  const Bodies bodies = tabletop();
  TsdfVolume volume(options);
  std::vector<Measurement> measurements;
  std::vector<std::size_t> blocks_before;
  for (const Eigen::Isometry3d& pose : poses) {
    measurements.push_back(prepare_measurement(render(bodies, camera, pose), camera, {}));
    volume.integrate(measurements.back(), pose);
    blocks_before.push_back(volume.index().size());
  }
  std::size_t compared = 0, wrong = 0;
  for (std::size_t slot = 0; slot < volume.index().size(); ++slot) {
    const Eigen::Vector3i first = volume.index().blocks()[slot] * TsdfBlock::edge;
    for (int i = 0; i < TsdfBlock::voxels; i += 3) {
      const Eigen::Vector3i voxel = first + Eigen::Vector3i(i & 7, (i >> 3) & 7, i >> 6);
      const Eigen::Vector3d center = (voxel.cast<double>().array() + 0.5) * options.voxel_size;
      ScalarVoxel expected;
      for (std::size_t k = 0; k < poses.size(); ++k) {
        if (slot >= blocks_before[k]) continue;
        expected = fuse_scalar(expected, center, measurements[k], poses[k].inverse(), volume);
        expected.distance = std::round(expected.distance);
      }
      if (!expected.decided) continue;
      ++compared;
      const auto at = static_cast<std::size_t>(i);
      const TsdfBlock& block = volume.block(slot);
      const bool right = block.weight[at] == expected.weight &&
                         std::abs(block.distance[at] - expected.distance) <= 1.0;
      if (!right && ++wrong == 1) {
        ADD_FAILURE() << "voxel " << voxel.transpose() << ": " << block.distance[at] << " of "
                      << block.weight[at] << ", not " << expected.distance << " of "
                      << expected.weight;
      }
    }
  }
  EXPECT_EQ(wrong, 0U);
  EXPECT_GT(compared, least);
}

std::vector<Eigen::Isometry3d> random_views(unsigned seed, double near) {
  std::mt19937 random(seed);
  std::vector<Eigen::Isometry3d> poses;
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int k = 0; k < 4; ++k) {
    const Eigen::Vector3d eye(near * uniform(random), near * uniform(random),
                              near * (1.2 + 0.5 * uniform(random)));
    poses.push_back(look_at(eye, {0.1 * uniform(random), 0.1 * uniform(random), 0.0}) *
                    motion({0, 0, 3.0 * uniform(random)}, {0, 0, 0}));
  }
  return poses;
}

TEST(TsdfVolume, EqualsTheFormulaForEveryVoxel) {
  expect_scalar_result({}, small_camera(), random_views(1, 0.5), 200000);
}

TEST(TsdfVolume, EqualsTheFormulaForWideLensesAndCloseBlocks) {
  const CameraIntrinsics wide{120, 90, 40.0, 40.0, 59.5, 44.5};
  expect_scalar_result({}, wide, random_views(2, 0.35), 200000);
  TsdfOptions coarse;
  coarse.voxel_size = 0.03;
  coarse.truncation = 0.06;
  coarse.max_truncation = 0.1;
  expect_scalar_result(coarse, wide, random_views(3, 0.3), 2000);
}

TEST(TsdfVolume, IsTheSameForAnyNumberOfThreads) {
  const auto run = [] {
    TsdfVolume volume;
    for (const double angle : {0.0, 0.1, 0.2}) {
      DepthFrame frame = render(tabletop(), small_camera(), around_table(angle));
      paint(frame, 30, 60, static_cast<std::uint8_t>(100.0 * angle));
      volume.integrate(prepare_measurement(frame, small_camera(), {}), around_table(angle));
    }
    return volume;
  };
  const TsdfVolume one = with_threads(1, run);
  EXPECT_GT(one.index().size(), 1000U);
  EXPECT_TRUE(same(with_threads(2, run), one));
  EXPECT_TRUE(same(with_threads(4, run), one));
}

TEST(TsdfVolume, TakesNoMoreMemoryWhenFramesRepeat) {
  TsdfOptions options;
  options.voxel_size = 0.006;
  TsdfVolume volume(options);
  const CameraIntrinsics tiny{40, 30, 35.0, 35.0, 19.5, 14.5};
  const DepthFrame frame = flat_frame(tiny, 0.6F);
  const Measurement measurement = prepare_measurement(frame, tiny, {});
  volume.integrate(measurement, Eigen::Isometry3d::Identity());
  const std::size_t before = volume.bytes(), blocks = volume.index().size();
  for (int k = 0; k < 1000; ++k) volume.integrate(measurement, Eigen::Isometry3d::Identity());
  EXPECT_EQ(volume.bytes(), before);
  EXPECT_EQ(volume.index().size(), blocks);
  for_each_seen_voxel(volume, [&](const Eigen::Vector3d& p, double distance, double) {
    if (std::abs(p.z() - 0.6) < 0.01) {
      EXPECT_NEAR(distance, 0.6 - p.z(), 2e-4);
    }
  });
}

TEST(TsdfVolume, StoresSurfacesAndNotSpace) {
  const TsdfVolume near = wall_volume(0.0);
  // 0.9 by 0.69 m of wall in blocks of 2.48 cm, three deep.
  EXPECT_LT(near.index().size(), 4000U);
}

TEST(TsdfVolume, IgnoresSurfacesBeyondItsReach) {
  const Measurement wall =
      prepare_measurement(flat_frame(small_camera(), 0.8F), small_camera(), {});
  for (const double far : {30.0, 1e5, 1e9, 1e15, -1e300}) {
    TsdfVolume volume;
    volume.integrate(wall, motion({0, 0, 0}, {far, 0, -far}));
    EXPECT_TRUE(volume.empty()) << far;
    volume.integrate(wall, Eigen::Isometry3d::Identity());
    const std::size_t blocks = volume.index().size();
    volume.integrate(wall, motion({0, 0, 0}, {0, far, far}));
    EXPECT_EQ(volume.index().size(), blocks) << far;
  }
}

TEST(TsdfVolume, HoldsDistancesAtTheEndOfItsReach) {
  const double reach = BlockIndex::reach * 8 * TsdfOptions().voxel_size;
  const Eigen::Isometry3d pose = motion({0, 0, 0}, {reach - 0.1, 0, -reach + 0.1});
  TsdfVolume volume;
  volume.integrate(prepare_measurement(flat_frame(small_camera(), 0.8F), small_camera(), {}), pose);
  EXPECT_FALSE(volume.empty());
  for_each_seen_voxel(volume, [&](const Eigen::Vector3d& p, double distance, double) {
    const double truth = pose.translation().z() + 0.8 - p.z();
    EXPECT_LT(p.x(), reach);
    if (std::abs(truth) < 0.01) {
      EXPECT_NEAR(distance, truth, 2e-4);
    }
  });
}

TEST(TsdfVolume, IgnoresInvalidPoses) {
  const Measurement wall =
      prepare_measurement(flat_frame(small_camera(), 0.8F), small_camera(), {});
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation().y() = std::numeric_limits<double>::quiet_NaN();
  TsdfVolume volume;
  volume.integrate(wall, pose);
  EXPECT_TRUE(volume.empty());
  volume.integrate(wall, Eigen::Isometry3d::Identity());
  const TsdfVolume before = wall_volume(0.0);
  volume.integrate(wall, pose);
  EXPECT_TRUE(same(volume, before));
}

}  // namespace
}  // namespace symscene
