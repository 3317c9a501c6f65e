#include "symscene/simulation/sensor_noise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "simulation/depth_renderer.hpp"
#include "simulation/shapes.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

const CameraIntrinsics test_camera{160, 120, 425, 425, 79.5, 59.5};

SensorFrame wall_at(double z, double reflectance = 0.6) {
  SensorFrame frame;
  frame.depth.assign(test_camera.pixels(), static_cast<float>(z));
  frame.objects.assign(test_camera.pixels(), 0);
  frame.cosines.assign(test_camera.pixels(), 1.0F);
  frame.colors = Colors::Constant(static_cast<Eigen::Index>(test_camera.pixels()), 3,
                                  static_cast<std::uint8_t>(255.0 * reflectance));
  return frame;
}

/// The right half stands nearer.
SensorFrame step(double near, double far) {
  SensorFrame frame = wall_at(far);
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    if (i % test_camera.width < test_camera.width / 2) continue;
    frame.depth[i] = static_cast<float>(near);
    frame.objects[i] = 1;
  }
  return frame;
}

SensorNoiseOptions sensor(SimulatedSensor model) {
  SensorNoiseOptions options;
  options.model = to_string(model);
  options.max_depth = 10.0;
  return options;
}

SensorFrame seen(const SensorFrame& exact, const SensorNoiseOptions& options,
                 std::uint64_t seed = 5) {
  return add_sensor_noise(exact, test_camera, options, Random(seed));
}

double deviation_of(const SensorFrame& noisy, double z) {
  double squares = 0.0, count = 0.0;
  for (const float measured : noisy.depth) {
    if (measured <= 0.0F) continue;
    squares += (measured - z) * (measured - z);
    ++count;
  }
  return std::sqrt(squares / count);
}

double missing_share(const SensorFrame& frame) {
  return static_cast<double>(std::count(frame.depth.begin(), frame.depth.end(), 0.0F)) /
         static_cast<double>(frame.depth.size());
}

TEST(StereoNoise, GrowsWithTheSquareOfTheDepth) {
  SensorNoiseOptions options = sensor(SimulatedSensor::stereo);
  options.stereo.disparity_step = 0.0;
  for (const double z : {0.5, 1.0, 2.0}) {
    const double expected =
        options.stereo.disparity_noise * z * z / (test_camera.fx * options.stereo.baseline);
    EXPECT_NEAR(deviation_of(seen(wall_at(z), options), z), expected, 0.1 * expected) << z;
  }
}

TEST(StereoNoise, IsCorrelatedOverAWindow) {
  SensorNoiseOptions options = sensor(SimulatedSensor::stereo);
  options.stereo.holes = options.stereo.shiny = options.stereo.disparity_step = 0.0;
  const SensorFrame noisy = seen(wall_at(1.0), options);
  const auto correlation = [&](std::size_t shift) {
    double products = 0.0, squares = 0.0;
    for (std::size_t i = 0; i + shift < noisy.depth.size(); ++i) {
      if (i % test_camera.width + shift >= test_camera.width) continue;
      const double a = noisy.depth[i] - 1.0, b = noisy.depth[i + shift] - 1.0;
      products += a * b;
      squares += a * a;
    }
    return products / squares;
  };
  EXPECT_GT(correlation(1), 0.7);
  EXPECT_LT(correlation(12), 0.2);
}

TEST(StereoNoise, FattensTheForegroundAndLeavesAShadowBesideIt) {
  SensorNoiseOptions options = sensor(SimulatedSensor::stereo);
  options.stereo.holes = options.stereo.shiny = 0.0;
  const SensorFrame noisy = seen(step(0.8, 1.2), options);
  std::size_t fattened = 0, hidden = 0;
  for (std::size_t i = 0; i < noisy.depth.size(); ++i) {
    const std::size_t u = i % test_camera.width;
    if (u >= test_camera.width / 2) continue;
    if (noisy.objects[i] == 1) {
      EXPECT_GE(u + static_cast<std::size_t>(options.stereo.window) / 2, test_camera.width / 2);
      ++fattened;
    }
    if (noisy.depth[i] == 0.0F) ++hidden;
  }
  // Half of a border two pixels wide; a shadow as wide as the disparities differ.
  const double rows = test_camera.height;
  const double shadow = test_camera.fx * options.stereo.baseline * (1.0 / 0.8 - 1.0 / 1.2);
  EXPECT_NEAR(static_cast<double>(fattened) / rows, 1.0, 0.5);
  EXPECT_NEAR(static_cast<double>(fattened + hidden) / rows, shadow, 1.5);
}

TEST(StereoNoise, LeavesHolesOnDarkAndOnShinySurfaces) {
  SensorNoiseOptions options = sensor(SimulatedSensor::stereo);
  options.stereo.shiny = 0.0;
  const double plain = missing_share(seen(wall_at(1.0), options));
  EXPECT_LT(plain, 0.03);
  EXPECT_GT(missing_share(seen(wall_at(1.0, 0.1), options)), plain + 0.1);
  options.stereo.shiny = 1.0;
  EXPECT_GT(missing_share(seen(wall_at(1.0), options)), plain + 0.1);
}

TEST(TimeOfFlightNoise, HardlyDependsOnTheDepthButOnTheLight) {
  SensorNoiseOptions options = sensor(SimulatedSensor::time_of_flight);
  options.tof.multipath = 0.0;
  const double near = deviation_of(seen(wall_at(0.6), options), 0.6);
  EXPECT_NEAR(near, options.tof.deviation, 0.1 * options.tof.deviation);
  EXPECT_NEAR(deviation_of(seen(wall_at(2.4), options), 2.4), near, 0.1 * near);
  EXPECT_GT(deviation_of(seen(wall_at(2.4, 0.1), options), 2.4), 1.3 * near);
  EXPECT_EQ(missing_share(seen(wall_at(6.0, 0.1), options)), 1.0);
}

TEST(TimeOfFlightNoise, HasFlyingPixelsBetweenTheSidesOfAnEdge) {
  SensorNoiseOptions options = sensor(SimulatedSensor::time_of_flight);
  options.tof.multipath = 0.0;
  const auto flying = [&] {
    const SensorFrame noisy = seen(step(0.8, 1.2), options);
    return std::count_if(noisy.depth.begin(), noisy.depth.end(),
                         [](float z) { return z > 0.82F && z < 1.18F; });
  };
  const double edge_pixels = 2.0 * (test_camera.height - 2);
  EXPECT_NEAR(static_cast<double>(flying()) / edge_pixels, 0.9 * options.tof.flying, 0.1);
  options.tof.flying = 0.0;
  EXPECT_EQ(flying(), 0);
}

TEST(TimeOfFlightNoise, ConcaveCornersAreTooFarAndPlanesAreNot) {
  // Two walls that meet at a right angle, 1 m away; a wall alone.
  std::vector<TriangleMesh> meshes;
  for (const double angle : {0.75, 1.25}) {
    Eigen::Isometry3d wall(Eigen::AngleAxisd(angle * std::numbers::pi, Eigen::Vector3d::UnitY()));
    wall.pretranslate(Eigen::Vector3d(0, 0, 1.0));
    meshes.push_back(transformed(make_box({0.001, 2, 1}, 2), wall));
  }
  for (TriangleMesh& mesh : meshes) mesh.colors = Colors::Constant(mesh.vertices.rows(), 3, 200);
  SensorNoiseOptions options = sensor(SimulatedSensor::time_of_flight);
  options.tof.deviation = options.tof.flying = 0.0;
  const auto largest_error = [&](std::span<const TriangleMesh> shown) {
    const SensorFrame exact =
        DepthRenderer(shown).render(test_camera, Eigen::Isometry3d::Identity());
    const SensorFrame noisy = seen(exact, options);
    double worst = 0.0;
    for (std::size_t i = 0; i < noisy.depth.size(); ++i) {
      if (noisy.depth[i] <= 0.0F) continue;
      EXPECT_GE(noisy.depth[i], exact.depth[i] - 1e-6F);
      worst = std::max<double>(worst, noisy.depth[i] - exact.depth[i]);
    }
    return worst;
  };
  EXPECT_GT(largest_error(meshes), 0.002);
  EXPECT_LT(largest_error(meshes), 0.05);
  EXPECT_LT(largest_error(std::span(meshes).subspan(1)), 1e-4);
}

TEST(SensorNoise, MissingLinesAreAtTheirInterval) {
  SensorNoiseOptions options;
  options.missing_lines = 4.0;
  const SensorFrame noisy = seen(wall_at(1.0), options);
  for (std::size_t i = 0; i < noisy.depth.size(); ++i) {
    const bool is_line = i % test_camera.width % 4 == 3 || i / test_camera.width % 4 == 3;
    EXPECT_EQ(noisy.depth[i] == 0.0F, is_line);
  }
}

TEST(SensorNoise, RefusesASensorThatItDoesNotKnow) {
  SensorNoiseOptions options;
  options.model = "lidar";
  EXPECT_THROW(seen(wall_at(1.0), options), InputError);
}

}  // namespace
}  // namespace symscene
