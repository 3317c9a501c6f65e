#include "reconstruction/tsdf_volume.hpp"

#include <gtest/gtest.h>

#include "reconstruction/analytic_scenes.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

TsdfOptions forgetting(double looks) {
  TsdfOptions options;
  options.max_contradicted_looks = looks;
  return options;
}

Body block_at(double depth) { return box(motion({0, 0, 0}, {0, 0, depth}), {0.06, 0.06, 0.05}); }

Bodies with_block(double distance) {
  return {plane(-Eigen::Vector3d::UnitZ(), distance), block_at(distance - 0.05)};
}

Bodies without_block(double distance) { return {plane(-Eigen::Vector3d::UnitZ(), distance)}; }

void fuse_again_and_again(TsdfVolume& volume, const Bodies& bodies, int frames) {
  const DepthFrame frame = render(bodies, small_camera(), Eigen::Isometry3d::Identity());
  const Measurement measurement = prepare_measurement(frame, small_camera(), {});
  for (int k = 0; k < frames; ++k) volume.integrate(measurement, Eigen::Isometry3d::Identity());
}

/// Highest point of the fused surface above a wall at this distance, near the middle. [m]
double height_after(const TsdfOptions& options, double distance, int before, int after,
                    bool is_added) {
  TsdfVolume volume(options);
  const Bodies first = is_added ? without_block(distance) : with_block(distance);
  const Bodies then = is_added ? with_block(distance) : without_block(distance);
  fuse_again_and_again(volume, first, before);
  fuse_again_and_again(volume, then, after);
  SurfaceExtractionOptions surface;
  surface.min_triangles = 1;
  const TriangleMesh mesh = extract_surface(volume, surface);
  double highest = 0.0;
  for (Index i = 0; i < mesh.vertices.rows(); ++i) {
    if (mesh.vertices.row(i).head<2>().norm() < 0.04F)
      highest = std::max(highest, distance - static_cast<double>(mesh.vertices(i, 2)));
  }
  return highest;
}

TEST(TsdfChange, WhatIsTakenAwayLeavesTheSurfaceWithinFifteenFramesAtAnyDistance) {
  for (const double distance : {0.5, 2.0}) {
    EXPECT_GT(height_after(forgetting(5.0), distance, 20, 0, false), 0.09) << distance;
    EXPECT_LT(height_after(forgetting(5.0), distance, 20, 15, false), 0.01) << distance;
  }
  EXPECT_GT(height_after({}, 1.0, 60, 15, false), 0.08);
}

TEST(TsdfChange, WhatIsAddedEntersTheSurfaceWithinFifteenFramesAtAnyDistance) {
  for (const double distance : {0.5, 2.0}) {
    EXPECT_LT(height_after(forgetting(5.0), distance, 20, 0, true), 0.01) << distance;
    EXPECT_NEAR(height_after(forgetting(5.0), distance, 20, 15, true), 0.1, 0.01) << distance;
  }
}

TEST(TsdfChange, ASceneAtRestIsFusedAsWithoutForgetting) {
  TsdfVolume keeping, forgetful(forgetting(5.0));
  for (int k = 0; k < 6; ++k) {
    const Eigen::Isometry3d pose = motion({0, 0, 0}, {0.001 * (k % 3), 0, 0});
    fuse(keeping, without_block(1.0), small_camera(), pose);
    fuse(forgetful, without_block(1.0), small_camera(), pose);
  }
  EXPECT_TRUE(same(keeping, forgetful));
}

TEST(TsdfChange, BothSidesOfAThinPlateStay) {
  // 5 mm thick, seen in turns from both sides: each side sees the other's space as behind itself.
  TsdfVolume keeping, forgetful(forgetting(5.0));
  const Eigen::Isometry3d back = motion({0, std::numbers::pi, 0}, {0, 0, 1.605});
  for (TsdfVolume* volume : {&keeping, &forgetful}) {
    for (int k = 0; k < 6; ++k) {
      fuse(*volume, {plane(-Eigen::Vector3d::UnitZ(), 0.8)}, small_camera(),
           Eigen::Isometry3d::Identity());
      fuse(*volume, {plane(Eigen::Vector3d::UnitZ(), -0.805)}, small_camera(), back);
    }
  }
  EXPECT_TRUE(same(keeping, forgetful));
}

}  // namespace
}  // namespace symscene
