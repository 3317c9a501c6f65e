#include "reconstruction/tsdf_volume.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "reconstruction/analytic_scenes.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

struct Views {
  TsdfOptions options;
  CameraIntrinsics camera;
  std::vector<Eigen::Isometry3d> poses;
};

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

/// Views through a lens of middle width, and through a wide one of near voxels and of coarse ones.
std::vector<Views> random_cases() {
  const CameraIntrinsics wide{120, 90, 40.0, 40.0, 59.5, 44.5};
  TsdfOptions coarse;
  coarse.voxel_size = 0.03;
  coarse.truncation = 0.06;
  coarse.max_truncation = 0.1;
  return {{{}, small_camera(), random_views(1, 0.5)},
          {{}, wide, random_views(2, 0.35)},
          {coarse, wide, random_views(3, 0.3)}};
}

Measurement measured(const Views& views, const Eigen::Isometry3d& pose) {
  return prepare_measurement(render(tabletop(), views.camera, pose), views.camera, {});
}

TEST(TsdfVolume, OfManyViewsIsTheWeightedMeanOfEachAlone) {
  for (const Views& views : random_cases()) {
    TsdfVolume all(views.options);
    std::vector<TsdfVolume> alone;
    for (const Eigen::Isometry3d& pose : views.poses) {
      const Measurement measurement = measured(views, pose);
      all.integrate(measurement, pose);
      alone.emplace_back(views.options).integrate(measurement, pose);
    }
    std::size_t compared = 0, wrong = 0;
    for (std::size_t slot = 0; slot < all.index().size(); ++slot) {
      std::vector<const TsdfBlock*> parts;
      for (const TsdfVolume& one : alone) {
        const std::int32_t own = one.index().find(all.index().blocks()[slot]);
        if (own != BlockIndex::none) parts.push_back(&one.block(static_cast<std::size_t>(own)));
      }
      // A view also changes blocks that only another one has added.
      if (parts.size() < alone.size()) continue;
      const TsdfBlock& block = all.block(slot);
      for (std::size_t i = 0; i < TsdfBlock::voxels; ++i) {
        int weight = 0;
        double sum = 0.0;
        for (const TsdfBlock* part : parts) {
          weight += part->weight[i];
          sum += static_cast<double>(part->weight[i]) * part->distance[i];
        }
        const bool is_mean = weight == 0 || std::abs(block.distance[i] - sum / weight) <= 3.0;
        ++compared;
        if (block.weight[i] != weight || !is_mean) ++wrong;
      }
    }
    EXPECT_EQ(wrong, 0U);
    EXPECT_GT(compared, 2000U);
  }
}

/// Whether one of the eight voxels around a point was seen.
bool is_seen_around(const TsdfVolume& volume, const Eigen::Vector3d& p) {
  const Eigen::Vector3i first =
      (p.array() / volume.options().voxel_size - 0.5).floor().cast<int>().matrix();
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3i voxel =
        first + Eigen::Vector3i(corner & 1, (corner >> 1) & 1, corner >> 2);
    const Eigen::Vector3i within = voxel.unaryExpr([](int c) { return c & 7; });
    const std::int32_t slot = volume.index().find((voxel - within) / TsdfBlock::edge);
    const auto place = static_cast<std::size_t>(within.x() + 8 * within.y() + 64 * within.z());
    if (slot != BlockIndex::none && volume.block(static_cast<std::size_t>(slot)).weight[place] > 0)
      return true;
  }
  return false;
}

TEST(TsdfVolume, SeesEverySurfaceThatAViewMeasuresWell) {
  for (const Views& views : random_cases()) {
    for (const Eigen::Isometry3d& pose : views.poses) {
      const Measurement measurement = measured(views, pose);
      TsdfVolume volume(views.options);
      volume.integrate(measurement, pose);
      std::size_t measured_well = 0, seen = 0;
      for (std::size_t i = 0; i < measurement.packed.size(); ++i) {
        const std::uint32_t packed = measurement.packed[i];
        if ((packed & 255) < 16) continue;  // a sixteenth of the weight of a frontal view at 1 m
        ++measured_well;
        const double depth = static_cast<double>(packed >> 16) * double{Measurement::depth_unit};
        const Eigen::Vector3d ray = views.camera.ray(static_cast<double>(i % views.camera.width),
                                                     static_cast<double>(i / views.camera.width));
        if (is_seen_around(volume, pose * Eigen::Vector3d(depth * ray))) ++seen;
      }
      EXPECT_GT(measured_well, 500U);
      EXPECT_GE(seen, measured_well * 99 / 100);
    }
  }
}

}  // namespace
}  // namespace symscene
