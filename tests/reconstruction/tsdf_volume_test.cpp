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

TEST(TsdfVolume, TruncatesFarDepthsAtALargerDistanceWithinABound) {
  const auto greatest = [](double depth) {
    TsdfVolume volume;
    fuse(volume, {plane(-Eigen::Vector3d::UnitZ(), depth)}, small_camera(),
         Eigen::Isometry3d::Identity());
    double most = 0.0;
    for_each_seen_voxel(volume, [&](const Eigen::Vector3d&, double distance, double) {
      most = std::max(most, distance);
    });
    return most;
  };
  const TsdfOptions options;
  EXPECT_NEAR(greatest(0.6), options.truncation, 1e-4);
  EXPECT_NEAR(greatest(0.9), options.truncation, 1e-4);  // the noise is still below it
  EXPECT_GT(greatest(2.0), 1.2 * options.truncation);
  EXPECT_GT(greatest(2.5), 1.2 * greatest(2.0));
  EXPECT_LE(greatest(2.9), options.max_truncation + 1e-4);
}

TEST(TsdfVolume, GathersLessWeightFarAwayAndAtAnAngleAndNoMoreThanABound) {
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
  const double once = weight_at_middle(1.0, 0.0, 1, 200);
  EXPECT_NEAR(once, 1.0, 0.07);  // the unit: one frontal view from 1 m
  EXPECT_NEAR(weight_at_middle(1.0, 0.0, 5, 200), 5.0 * once, 1e-6);
  EXPECT_GT(weight_at_middle(0.7, 0.0, 1, 200), 2.0 * once);
  EXPECT_LT(weight_at_middle(0.7, 0.6, 1, 200), 0.8 * weight_at_middle(0.7, 0.0, 1, 200));
  EXPECT_NEAR(weight_at_middle(2.0, 0.0, 1, 200), std::pow(2.0, -4), 0.1 * std::pow(2.0, -4));
  EXPECT_NEAR(weight_at_middle(2.9, 0.0, 1, 200), std::pow(2.9, -4), 0.2 * std::pow(2.9, -4));
  EXPECT_LT(weight_at_middle(2.0, 0.7, 1, 200), 0.4 * weight_at_middle(2.0, 0.0, 1, 200));
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
  fuse(volume, {plane(Eigen::Vector3d::UnitZ(), -0.805)}, camera, back);
  int behind = 0;
  for_each_seen_voxel(volume, [&](const Eigen::Vector3d& p, double distance, double) {
    if (p.head<2>().norm() > 0.2 || p.z() < 0.8085) return;
    ++behind;
    EXPECT_GT(distance, 0.0) << p.transpose();
  });
  EXPECT_GT(behind, 1000);
}

/// How far back a wall at this depth is placed by 60 frames with the sensor's noise. [deviations]
double bias_of_wall(double depth, const TsdfOptions& options) {
  std::mt19937 random(5);
  TsdfVolume volume(options);
  double sum = 0.0;
  int count = 0;
  for (int k = 0; k < 60; ++k) {
    DepthFrame frame = flat_frame(small_camera(), static_cast<float>(depth));
    for (float& z : frame.depth)
      z += static_cast<float>(1.425e-3 * depth * depth) * std::normal_distribution<float>()(random);
    volume.integrate(prepare_measurement(frame, small_camera(), {}), Eigen::Isometry3d::Identity());
  }
  for_each_seen_voxel(volume, [&](const Eigen::Vector3d& p, double distance, double) {
    if (std::abs(p.z() - depth) > 0.0016 || p.head<2>().norm() > 0.3 * depth) return;
    sum += distance - (depth - p.z());
    ++count;
  });
  return sum / count / (1.425e-3 * depth * depth);
}

TEST(TsdfVolume, PlacesFarNoisyWallsWithoutBias) {
  for (const double depth : {1.0, 2.0, 2.6})
    EXPECT_LT(std::abs(bias_of_wall(depth, {})), 0.06) << depth;
  TsdfOptions by_share;
  by_share.full_weight_sigmas = 0.0;
  by_share.zero_weight_sigmas = 0.01;
  EXPECT_GT(bias_of_wall(2.6, by_share), 0.1);
}

TEST(TsdfVolume, IsNotExtendedBeyondItsLargestMemory) {
  TsdfOptions options;
  options.max_memory = 1e-3;
  TsdfVolume volume(options);
  const Bodies wall{plane(-Eigen::Vector3d::UnitZ(), 1.0)};
  EXPECT_FALSE(volume.is_full());
  for (const double x : {0.0, 2.0, 4.0})
    fuse(volume, wall, small_camera(), motion({0, 0, 0}, {x, 0, 0}));
  EXPECT_TRUE(volume.is_full());
  EXPECT_GT(volume.index().size(), 100U);
  EXPECT_LE(volume.index().size() * (sizeof(TsdfBlock) + sizeof(ColorBlock)), 1000000U);
}

TEST(TsdfVolume, IgnoresPixelsWithoutAMeasurement) {
  for (const float depth : {0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity(), 1e30F, 1e-30F, 0.19F, 6.01F}) {
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
