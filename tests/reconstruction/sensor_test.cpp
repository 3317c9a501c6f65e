#include "symscene/reconstruction/sensor.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "reconstruction/analytic_scenes.hpp"
#include "symscene/core/depth_noise.hpp"
#include "symscene/core/error.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

const CameraIntrinsics table_camera{320, 240, 262.0, 262.0, 159.5, 119.5};

/// A table that runs from 0.7 to 2.5 m if it is 0.6 m away, with noise of a deviation that follows
/// the depth, averaged over windows of some pixels.
DepthFrame slanted_table(const std::function<double(double)>& deviation, int window,
                         double distance = 0.6) {
  const Bodies table{plane(Eigen::Vector3d(0, -0.85, -0.53).normalized(), distance)};
  DepthFrame frame = render(table, table_camera, Eigen::Isometry3d::Identity());
  std::mt19937 random(4);
  std::vector<double> white(table_camera.pixels());
  for (double& value : white) value = std::normal_distribution<double>()(random);
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    double sum = 0.0;
    for (int k = 0; k < window * window; ++k) {
      const std::size_t at = i + static_cast<std::size_t>(k / window) * table_camera.width +
                             static_cast<std::size_t>(k % window);
      sum += white[at % white.size()];
    }
    frame.depth[i] += static_cast<float>(deviation(frame.depth[i]) * sum / window);
  }
  return frame;
}

SensorEstimate estimate(const DepthFrame& frame) {
  return estimate_sensor({&frame, 1}, table_camera);
}

TEST(Sensor, IsToldByTheGrowthOfTheNoiseAndItsCorrelation) {
  const auto quadratic = [](double z) { return 1.4e-3 * z * z; };
  const SensorEstimate light = estimate(slanted_table(quadratic, 1));
  EXPECT_EQ(light.sensor, Sensor::structured_light);
  EXPECT_NEAR(light.exponent, 2.0, 0.3);
  EXPECT_NEAR(light.deviation_at_1m, 1.4e-3, 0.2e-3);
  const SensorEstimate stereo = estimate(slanted_table(quadratic, 7));
  EXPECT_EQ(stereo.sensor, Sensor::stereo);
  EXPECT_GT(stereo.correlation, light.correlation);
  const SensorEstimate flight = estimate(slanted_table([](double) { return 1.5e-3; }, 1));
  EXPECT_EQ(flight.sensor, Sensor::time_of_flight);
  EXPECT_NEAR(flight.exponent, 0.0, 0.3);
  EXPECT_NEAR(flight.deviation_at_1m, 1.5e-3, 0.2e-3);
}

TEST(Sensor, IsNotNamedWhereTheNoiseDoesNotTellIt) {
  // Constant, but correlated as that of no time-of-flight camera.
  const SensorEstimate odd = estimate(slanted_table([](double) { return 3e-3; }, 4));
  EXPECT_FALSE(odd.sensor);
  EXPECT_FALSE(odd.too_little);
  EXPECT_FALSE(odd.reason.empty());
  // One depth, no noise, no depth.
  const DepthFrame exact = slanted_table([](double) { return 0.0; }, 1);
  for (const DepthFrame& frame :
       {flat_frame(table_camera, 1.0F), flat_frame(table_camera, 0.0F), exact}) {
    const SensorEstimate none = estimate(frame);
    EXPECT_FALSE(none.sensor);
    EXPECT_TRUE(none.too_little);
  }
  EXPECT_FALSE(estimate_sensor({}, table_camera).sensor);
}

DepthFrame in_millimetres(DepthFrame frame) {
  for (float& depth : frame.depth) depth = std::round(1000.0F * depth) / 1000.0F;
  return frame;
}

TEST(Sensor, RoundingIsNotTakenForNoise) {
  // From 0.27 to 0.96 m: below 0.45 m rounding is most of the noise of structured light.
  constexpr double near = 0.23;
  const auto quadratic = [](double z) { return 1.425e-3 * z * z; };
  const SensorEstimate light = estimate(in_millimetres(slanted_table(quadratic, 1, near)));
  EXPECT_NEAR(light.step, 1e-3, 1e-6);
  EXPECT_GT(light.rounded, 0U);
  EXPECT_EQ(light.sensor, Sensor::structured_light) << light.exponent;
  EXPECT_NEAR(light.exponent, 2.0, 0.4);
  EXPECT_NEAR(light.deviation_at_1m, 1.4e-3, 0.2e-3);
  const auto constant = [](double) { return 1.5e-3; };
  const SensorEstimate flight = estimate(in_millimetres(slanted_table(constant, 1, near)));
  EXPECT_EQ(flight.sensor, Sensor::time_of_flight) << flight.exponent;
  EXPECT_EQ(flight.rounded, 0U);
  // Only rounding.
  const auto exact = [](double) { return 0.0; };
  const SensorEstimate none = estimate(in_millimetres(slanted_table(exact, 1)));
  EXPECT_TRUE(none.too_little);
  EXPECT_NE(none.reason.find("rounding"), std::string::npos) << none.reason;
}

TEST(Sensor, NamesAreReadBack) {
  for (const Sensor sensor : {Sensor::structured_light, Sensor::stereo, Sensor::time_of_flight})
    EXPECT_EQ(parse_sensor(to_string(sensor)), sensor);
  EXPECT_THROW(parse_sensor("lidar"), InputError);
}

TEST(Sensor, HasNoiseThatGrowsAsItsKindDoes) {
  EXPECT_EQ(depth_noise(Sensor::structured_light, table_camera, 2.0), structured_light_noise);
  EXPECT_EQ(depth_noise(Sensor::stereo, table_camera, 1.0),
            depth_noise(Sensor::stereo, table_camera, 2.0));
  EXPECT_NEAR(depth_noise(Sensor::time_of_flight, table_camera, 0.4) * 0.16, 1.3e-3, 1e-9);
  EXPECT_EQ(depth_noise(Sensor::time_of_flight, table_camera, 2.0), structured_light_noise);
}

TEST(Sensor, FlyingPixelsAreRemovedAndSurfacesStay) {
  DepthFrame frame = flat_frame(table_camera, 1.0F);
  std::set<std::size_t> flying;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    const std::size_t u = i % table_camera.width, v = i / table_camera.width;
    if (u > 100) frame.depth[i] = 1.5F + 0.002F * static_cast<float>(u);
    if (u == 100) frame.depth[i] = 1.3F;
    if (u == 100 && v > 0 && v + 1 < table_camera.height) flying.insert(i);
  }
  const DepthFrame cleaned = without_flying_pixels(frame, table_camera, 0.015);
  for (std::size_t i = 0; i < frame.depth.size(); ++i)
    EXPECT_EQ(cleaned.depth[i], flying.contains(i) ? 0.0F : frame.depth[i]) << i;
}

}  // namespace
}  // namespace symscene
