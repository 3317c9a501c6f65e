#include "symscene/simulation/camera_errors.hpp"

#include <gtest/gtest.h>

#include "simulation/erring_camera.hpp"
#include "simulation/shapes.hpp"
#include "symscene/core/frame_rectifier.hpp"

namespace symscene {
namespace {

const CameraIntrinsics camera{160, 120, 131.0, 131.0, 79.5, 59.5};

/// The face of a box, 1 m in front of the camera.
DepthRenderer wall() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation().z() = 1.0;
  const TriangleMesh mesh = transformed(make_box({6.0, 6.0, 0.1}, 1.0), pose);
  return DepthRenderer(std::span(&mesh, 1));
}

CameraErrorOptions errors() {
  CameraErrorOptions options;
  options.k1 = -0.1;
  options.p2 = 0.002;
  options.depth_bias = 0.02;
  return options;
}

TEST(DepthBias, IsWithinItsBoundAndGrowsWithRange) {
  const DepthBias bias(errors(), camera);
  for (Index u = 0; u < camera.width; u += 13) {
    const double at_2m = bias.factor(u, 40, 2.0) - 1.0;
    EXPECT_LE(std::abs(at_2m), 0.02);
    EXPECT_NEAR(bias.factor(u, 40, 1.0) - 1.0, 0.5 * at_2m, 1e-12);
  }
  EXPECT_NE(bias.factor(0, 0, 2.0), bias.factor(150, 100, 2.0));
}

TEST(ErringCamera, WithoutErrorsIsThePinholeCamera) {
  const DepthRenderer renderer = wall();
  const Eigen::Isometry3d pose(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()));
  EXPECT_EQ(ErringCamera(camera, {}).render(renderer, pose).depth,
            renderer.render(camera, pose).depth);
}

TEST(ErringCamera, TheRectifierUndoesItsDistortion) {
  const DepthRenderer renderer = wall();
  const Eigen::Isometry3d pose(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()));
  CameraErrorOptions distorted = errors();
  distorted.depth_bias = 0.0;
  const SensorFrame seen = ErringCamera(camera, distorted).render(renderer, pose);
  const SensorFrame exact = renderer.render(camera, pose);
  const DepthFrame again = FrameRectifier({camera, distorted.lens(), {}, {}})
                               .rectified(DepthFrame{0.0, seen.depth, seen.colors});
  double before = 0.0, after = 0.0;
  for (std::size_t i = 0; i < again.depth.size(); ++i) {
    if (again.depth[i] == 0.0F) continue;
    before = std::max(before, std::abs(double{seen.depth[i]} - exact.depth[i]));
    after = std::max(after, std::abs(double{again.depth[i]} - exact.depth[i]));
  }
  EXPECT_GT(before, 0.004);
  EXPECT_LT(after, 0.0015);  // half a pixel along the slope
}

TEST(ErringCamera, AnOffsetColourCameraSeesThePlaceBeside) {
  const DepthRenderer renderer = wall();
  CameraErrorOptions options;
  options.color_offset = 0.1;
  const ErringCamera erring(camera, options);
  // The wall ends 3 m to the right; its edge appears 0.1 m further to the left.
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation().x() = 2.9;
  const SensorFrame seen = erring.render(renderer, pose);
  const Colors colors = erring.colors(renderer, seen);
  const Eigen::Index row = 60 * 160;
  const auto width_of = [&](const Colors& image) {
    int shown = 0;
    for (Eigen::Index u = 0; u < 160; ++u) shown += image(row + u, 0) > 0 ? 1 : 0;
    return shown;
  };
  EXPECT_NEAR(width_of(seen.colors) - width_of(colors), 131 * 0.1, 1.1);
}

}  // namespace
}  // namespace symscene
