#include "symscene/simulation/sweep.hpp"

#include <gtest/gtest.h>

#include <set>

#include "simulation/hand_shake.hpp"
#include "simulation/shapes.hpp"
#include "simulation/true_surface.hpp"
#include "symscene/core/error.hpp"
#include "symscene/simulation/truth_transfer.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

SweepOptions small_sweep(int frames) {
  SweepOptions options;
  options.tabletop.objects = 3;
  options.tabletop.seed = 3;
  options.camera.frames = frames;
  options.camera.width = 160;
  options.camera.height = 120;
  options.camera.focal_length = 131.0;
  return options;
}

struct Taken {
  DepthFrame frame;
  Eigen::Isometry3d T_world_camera;
};

std::vector<Taken> take(const SweepOptions& options) {
  std::vector<Taken> taken;
  capture_sweep(arrange_tabletop(options.tabletop), options,
                [&](const DepthFrame& frame, const Eigen::Isometry3d& pose) {
                  taken.push_back({frame, pose});
                });
  return taken;
}

std::vector<Eigen::Isometry3d> standing_still(std::size_t frames) {
  return std::vector<Eigen::Isometry3d>(frames, Eigen::Isometry3d::Identity());
}

TEST(CaptureSensorFrames, ShowTheObjectsOfTheDepthImages) {
  const SweepOptions options = small_sweep(2);
  const std::vector<Taken> taken = take(options);
  std::size_t next = 0;
  std::set<Index> shown;
  capture_sensor_frames(arrange_tabletop(options.tabletop), options,
                        [&](double time, SensorFrame&& seen) {
                          const Taken& same = taken.at(next++);
                          EXPECT_EQ(time, same.frame.time);
                          EXPECT_EQ(seen.depth, same.frame.depth);
                          for (std::size_t i = 0; i < seen.depth.size(); ++i) {
                            const bool is_measured = seen.depth[i] > 0.0F;
                            EXPECT_EQ(is_measured, seen.objects[i] != SensorFrame::nothing);
                            if (is_measured) shown.insert(seen.objects[i]);
                          }
                        });
  EXPECT_EQ(next, 2U);
  EXPECT_EQ(shown, (std::set<Index>{0, 1, 2, 3})) << "three objects and the table";
}

TEST(HandShake, IsSmoothAndBounded) {
  const HandShakeOptions options;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto path = shaken(standing_still(300), 30.0, options, seed);
    double squared = 0.0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const Eigen::Vector3d shift = path[i].translation();
      EXPECT_LE(shift.cwiseAbs().maxCoeff(), 4.0 * options.translation);
      EXPECT_LE(Eigen::AngleAxisd(path[i].linear()).angle(),
                4.0 * std::sqrt(3.0) * options.rotation);
      squared += shift.squaredNorm() / 3.0;
      if (i == 0) continue;
      // No wave is faster than the band allows.
      const double step = 2.0 * std::numbers::pi * options.max_frequency / 30.0;
      EXPECT_LE((shift - path[i - 1].translation()).cwiseAbs().maxCoeff(),
                4.0 * options.translation * step);
    }
    const double deviation = std::sqrt(squared / static_cast<double>(path.size()));
    EXPECT_NEAR(deviation, options.translation, 0.3 * options.translation);
  }
}

TEST(HandShake, OfZeroDeviationLeavesThePathUnchanged) {
  HandShakeOptions none;
  none.translation = none.rotation = 0.0;
  for (const Eigen::Isometry3d& pose : shaken(standing_still(20), 30.0, none, 1))
    EXPECT_TRUE(pose.isApprox(Eigen::Isometry3d::Identity()));
}

TEST(Sweep, FramesComeInOrderAndOneFrameIntervalApart) {
  const std::vector<Taken> taken = take(small_sweep(9));
  ASSERT_EQ(taken.size(), 9U);
  for (std::size_t i = 0; i < taken.size(); ++i)
    EXPECT_NEAR(taken[i].frame.time, static_cast<double>(i) / 30.0, 1e-12);
}

TEST(Sweep, GivesTheSameBytesForAnyNumberOfThreads) {
  const auto run = [] { return take(small_sweep(6)); };
  const std::vector<Taken> one = testing::with_threads(1, run);
  const std::vector<Taken> two = testing::with_threads(2, run);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].frame.depth, two[i].frame.depth);
    EXPECT_EQ(one[i].frame.colors, two[i].frame.colors);
    EXPECT_EQ(one[i].T_world_camera.matrix(), two[i].T_world_camera.matrix());
  }
}

TEST(Sweep, PassesOnWhatTheSinkThrows) {
  const SweepOptions options = small_sweep(5);
  int frames = 0;
  const auto stop = [&](const DepthFrame&, const Eigen::Isometry3d&) {
    if (++frames == 2) throw std::runtime_error("full");
  };
  EXPECT_THROW(capture_sweep(arrange_tabletop(options.tabletop), options, stop),
               std::runtime_error);
  EXPECT_EQ(frames, 2);
}

/// The points that a frame measures, in the world's frame.
Points measured(const Taken& taken, const CameraIntrinsics& camera) {
  std::vector<Eigen::Vector3d> points;
  for (Index v = 0; v < camera.height; ++v) {
    for (Index u = 0; u < camera.width; ++u) {
      const double z = taken.frame.depth[std::size_t{v} * camera.width + u];
      if (z > 0.0) points.push_back(taken.T_world_camera * (z * camera.ray(u, v)));
    }
  }
  Points result(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    result.row(static_cast<Eigen::Index>(i)) = points[i].cast<float>().transpose();
  return result;
}

TEST(Sweep, MeasuredPointsLieOnTheTrueSurfaces) {
  SweepOptions options = small_sweep(4);
  options.tabletop.random_frame = true;
  const Tabletop tabletop = arrange_tabletop(options.tabletop);
  std::vector<TriangleMesh> meshes;
  for (const PlacedObject& placed : tabletop.objects) meshes.push_back(world_mesh(placed));
  for (const Taken& taken : take(options)) {
    const Points points = measured(taken, options.camera.intrinsics());
    ASSERT_GT(points.rows(), 10000);
    const SurfaceErrors errors = surface_errors(points, meshes, tabletop.plane());
    EXPECT_LT(errors.median, 0.0015);
    EXPECT_LT(errors.percentile_95, 0.01);
  }
}

TEST(Sweep, EveryMeshHasAUniqueName) {
  Tabletop tabletop;
  for (const char* name : {"mug", "mug", "mug_2", "mug"}) {
    tabletop.objects.emplace_back();
    tabletop.objects.back().object.name = name;
  }
  const std::vector<std::string> names = mesh_names(tabletop);
  EXPECT_EQ(names[0], "mug");
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), 4U);
}

TEST(Sweep, RefusesOptionsOutOfTheirRange) {
  SweepOptions options = small_sweep(4);
  options.frame_rate = 0.0;
  EXPECT_THROW(take(options), InputError);
  options = small_sweep(4);
  options.shake.max_frequency = 0.1;
  EXPECT_THROW(take(options), InputError);
}

}  // namespace
}  // namespace symscene
