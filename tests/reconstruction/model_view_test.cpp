#include "reconstruction/model_view.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "reconstruction/analytic_scenes.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

constexpr double voxel = 0.0031;

/// A view compared with the ground truth.
struct Comparison {
  std::size_t both = 0;      ///< pixels with surface in the view and in the ground truth
  std::size_t missing = 0;   ///< pixels with surface in the ground truth alone
  std::size_t invented = 0;  ///< pixels with surface in the view alone
  std::size_t far_off = 0;   ///< of both, more than two voxels from the ground truth
  double median = 0.0;       ///< distance of both along the normal [m]
};

Comparison compare(const ModelView& view, const Bodies& bodies) {
  Comparison result;
  std::vector<double> gaps;
  const CameraIntrinsics& camera = view.image.camera;
  for (Index v = 0; v < camera.height; ++v) {
    for (Index u = 0; u < camera.width; ++u) {
      const SurfacePixel& pixel = view.image.pixels[std::size_t{v} * camera.width + u];
      const double truth = depth_at(bodies, camera, view.T_world_camera, u, v);
      const bool shown = pixel.depth > 0.0F;
      result.missing += !shown && truth > 0.0 ? 1 : 0;
      result.invented += shown && truth == 0.0 ? 1 : 0;
      if (!shown || truth == 0.0) continue;
      ++result.both;
      const Eigen::Vector3d normal(static_cast<double>(pixel.nx), static_cast<double>(pixel.ny),
                                   static_cast<double>(pixel.nz));
      EXPECT_NEAR(normal.norm(), 1.0, 1e-4);
      EXPECT_LT(normal.dot(camera.ray(u, v)), 0.0) << "a normal away from the camera";
      const double gap =
          std::abs((static_cast<double>(pixel.depth) - truth) * normal.dot(camera.ray(u, v)));
      result.far_off += gap > 2.0 * voxel ? 1 : 0;
      gaps.push_back(gap);
    }
  }
  if (gaps.empty()) return result;
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::nth_element(gaps.begin(), middle, gaps.end());
  result.median = *middle;
  return result;
}

TsdfVolume table_volume() {
  TsdfVolume volume;
  for (double angle = -0.4; angle < 0.45; angle += 0.1) {
    fuse(volume, tabletop(), small_camera(), around_table(angle));
  }
  return volume;
}

TEST(ModelView, ShowsTheTrueDepthOfATabletop) {
  const ModelView view = cast_model_view(table_volume(), small_camera(), around_table(0.05));
  const Comparison result = compare(view, tabletop());
  const std::size_t pixels = small_camera().pixels();
  EXPECT_GT(result.both, 9 * pixels / 10);
  EXPECT_LT(result.median, 0.25 * voxel);
  EXPECT_LT(result.far_off, pixels / 100);
}

TEST(ModelView, ShowsABallFromEverySideAndNothingAroundIt) {
  const Eigen::Vector3d center(0.02, 0.01, -0.03);
  const Bodies ball{sphere(center, 0.1)};
  const TsdfVolume volume = seen_from_everywhere(ball, center, 40);
  for (const Eigen::Isometry3d& pose : views_around(center, 0.4, 7)) {
    const Comparison result = compare(cast_model_view(volume, small_camera(), pose), ball);
    EXPECT_GT(result.both, 3000U);
    EXPECT_LT(result.median, 0.15 * voxel);
    EXPECT_EQ(result.far_off, 0U);
    // At the ball's outline rays graze it.
    EXPECT_LT(result.missing, result.both / 20);
    EXPECT_LT(result.invented, result.both / 50);
  }
}

TEST(ModelView, ShowsAWallAtGrazingAngles) {
  TsdfVolume volume;
  const Bodies wall{plane(-Eigen::Vector3d::UnitZ(), 0.6)};
  fuse(volume, wall, small_camera(), Eigen::Isometry3d::Identity());
  // 80° from the normal at the middle of the image, less above it and more below.
  const double slant = radians(80.0);
  const Eigen::Isometry3d pose = Eigen::Translation3d(0, 0, 0.6) *
                                 motion({slant, 0, 0}, {0, 0, 0}) *
                                 Eigen::Translation3d(0, 0, -0.3);
  const ModelView view = cast_model_view(volume, small_camera(), pose);
  std::size_t shown = 0, inside = 0;
  for (Index v = 0; v < 120; ++v) {
    for (Index u = 0; u < 160; ++u) {
      const double depth = depth_at(wall, small_camera(), pose, u, v);
      const Eigen::Vector3d p = pose * (depth * small_camera().ray(u, v));
      if (depth == 0.0 || std::abs(p.x()) > 0.3 || std::abs(p.y()) > 0.22) continue;
      const double cosine = (p - pose.translation()).normalized().z();
      const bool expected = cosine > std::cos(radians(82.0));
      inside += expected ? 1 : 0;
      const SurfacePixel& pixel = view.image.pixels[v * 160 + u];
      if (pixel.depth == 0.0F) continue;
      shown += expected ? 1 : 0;
      const Eigen::Vector3d q =
          pose * (static_cast<double>(pixel.depth) * small_camera().ray(u, v));
      EXPECT_NEAR(q.z(), 0.6, 0.1 * voxel);
    }
  }
  EXPECT_GT(inside, 1000U);
  EXPECT_GT(shown, 99 * inside / 100);
}

TEST(ModelView, ShowsCloseSurfacesWhenTheCameraIsInsideABlock) {
  TsdfVolume volume;
  const Bodies wall{plane(-Eigen::Vector3d::UnitZ(), 0.6)};
  for (int k = 0; k < 2; ++k) {
    fuse(volume, wall, small_camera(), Eigen::Isometry3d::Identity());
  }
  for (const double distance : {0.2, 0.08, 0.05, 0.03}) {
    const Eigen::Isometry3d pose = motion({0, 0, 0}, {0.01, 0.02, 0.6 - distance});
    const Comparison result = compare(cast_model_view(volume, small_camera(), pose), wall);
    EXPECT_EQ(result.missing, 0U) << distance;
    EXPECT_LT(result.median, 0.05 * voxel) << distance;
  }
}

TEST(ModelView, IsEmptyForAnEmptyVolumeAndForOneThatIsNotInView) {
  const auto shown = [](const ModelView& view) {
    return std::count_if(view.image.pixels.begin(), view.image.pixels.end(),
                         [](const SurfacePixel& p) { return p.depth != 0.0F || p.nz != 0.0F; });
  };
  EXPECT_EQ(shown(cast_model_view(TsdfVolume(), small_camera(), around_table(0))), 0);
  TsdfVolume volume;
  const Bodies wall{plane(-Eigen::Vector3d::UnitZ(), 0.6)};
  fuse(volume, wall, small_camera(), Eigen::Isometry3d::Identity());
  const auto from = [&](const Eigen::Isometry3d& pose) {
    return shown(cast_model_view(volume, small_camera(), pose));
  };
  EXPECT_EQ(from(motion({0, std::numbers::pi, 0}, {0, 0, 0})), 0) << "turned away";
  EXPECT_EQ(from(motion({0, std::numbers::pi, 0}, {0, 0, 1.2})), 0) << "from behind";
  EXPECT_EQ(from(motion({0, 0, 0}, {0, 0, 1e6})), 0);
  EXPECT_EQ(from(motion({0, 0, 0}, {0, 0, -1e15})), 0);
  Eigen::Isometry3d no_pose = Eigen::Isometry3d::Identity();
  no_pose.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(from(no_pose), 0);
  no_pose = Eigen::Isometry3d::Identity();
  no_pose.linear()(2, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(from(no_pose), 0);
}

TEST(ModelView, IsEquivariantUnderRigidMotion) {
  // The same grid after a shift by whole blocks: the same image.
  const Bodies wall{plane(-Eigen::Vector3d(0.3, 0.1, 1).normalized(), 0.7)};
  const auto view_at = [&](const Eigen::Vector3d& shift) {
    TsdfVolume volume;
    const Measurement measurement = prepare_measurement(
        render(wall, small_camera(), Eigen::Isometry3d::Identity()), small_camera(), {});
    volume.integrate(measurement, motion({0, 0, 0}, shift));
    return cast_model_view(volume, small_camera(), motion({0, 0.05, 0}, shift));
  };
  const ModelView here = view_at({0, 0, 0}),
                  there = view_at(8 * voxel * Eigen::Vector3d(40, -9, 3));
  std::size_t shown = 0, apart = 0;
  for (std::size_t i = 0; i < here.image.pixels.size(); ++i) {
    const float a = here.image.pixels[i].depth, b = there.image.pixels[i].depth;
    if (a == 0.0F || b == 0.0F) continue;
    ++shown;
    apart += std::abs(a - b) > 2e-4F ? 1 : 0;
  }
  EXPECT_GT(shown, 10000U);
  EXPECT_LT(apart, shown / 50);
}

TEST(ModelView, OfOddSizeHasEveryPixel) {
  TsdfVolume volume;
  const Bodies wall{plane(-Eigen::Vector3d::UnitZ(), 0.6)};
  fuse(volume, wall, small_camera(), Eigen::Isometry3d::Identity());
  for (const Index width : {1U, 7U, 17U}) {
    const CameraIntrinsics odd{width, width + 2, 60.0, 60.0, 0.5 * (width - 1), 0.5 * (width + 1)};
    const Comparison result =
        compare(cast_model_view(volume, odd, Eigen::Isometry3d::Identity()), wall);
    EXPECT_EQ(result.both, odd.pixels());
  }
}

TEST(ModelView, IsTheSameForAnyNumberOfThreads) {
  const TsdfVolume volume = table_volume();
  const auto run = [&] { return cast_model_view(volume, small_camera(), around_table(0.1)).image; };
  const SurfaceImage one = with_threads(1, run);
  EXPECT_TRUE(same(with_threads(2, run), one));
  EXPECT_TRUE(same(with_threads(4, run), one));
}

}  // namespace
}  // namespace symscene
