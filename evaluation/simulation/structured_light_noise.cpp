#include <algorithm>
#include <cmath>

#include "grainy_noise.hpp"
#include "sensor_models.hpp"

namespace symscene {
namespace {

std::size_t jittered_pixel(Index u, Index v, const CameraIntrinsics& camera, double sigma,
                           Random& random) {
  const auto shifted = [&](Index at, Index size) {
    const auto place = static_cast<std::int64_t>(std::lround(at + sigma * random.normal()));
    return static_cast<std::size_t>(std::clamp<std::int64_t>(place, 0, std::int64_t{size} - 1));
  };
  const std::size_t column = shifted(u, camera.width);
  return shifted(v, camera.height) * camera.width + column;
}

bool is_at_edge(const SensorFrame& frame, const CameraIntrinsics& camera, Index u, Index v,
                double step) {
  if (u == 0 || v == 0 || u + 1 == camera.width || v + 1 == camera.height) return false;
  const std::size_t pixel = std::size_t{v} * camera.width + u;
  const float z = frame.depth[pixel];
  for (const std::size_t other :
       {pixel - 1, pixel + 1, pixel - camera.width, pixel + camera.width}) {
    if (std::abs(frame.depth[other] - z) > step) return true;
  }
  return false;
}

double with_axial_error(double z, double unit_noise, const SensorNoiseOptions& options) {
  const double noisy = z + options.axial * z * z * unit_noise;
  if (options.disparity_step == 0.0) return noisy;
  return 1.0 / (std::round(1.0 / (noisy * options.disparity_step)) * options.disparity_step);
}

}  // namespace

SensorFrame structured_light_frame(const SensorFrame& exact, const CameraIntrinsics& camera,
                                   const SensorNoiseOptions& options, Random random) {
  SensorFrame noisy = exact;
  const GrainyNoise noise(camera, options.grain, random);
  for (Index v = 0; v < camera.height; ++v) {
    for (Index u = 0; u < camera.width; ++u) {
      const std::size_t pixel = std::size_t{v} * camera.width + u;
      const std::size_t source = jittered_pixel(u, v, camera, options.lateral, random);
      const double z = exact.depth[source];
      const double lost =
          std::max(grazing_loss(exact, source, options),
                   is_at_edge(exact, camera, u, v, options.edge_step) ? options.edge_dropout : 0.0);
      const bool measured = z > 0.0 && z < options.max_depth && !random.chance(lost);
      noisy.depth[pixel] =
          measured ? static_cast<float>(with_axial_error(z, noise.at(u, v), options)) : 0.0F;
      noisy.objects[pixel] = measured ? exact.objects[source] : SensorFrame::nothing;
      noisy.cosines[pixel] = exact.cosines[source];
      noisy.colors.row(static_cast<Eigen::Index>(pixel)) =
          exact.colors.row(static_cast<Eigen::Index>(source));
    }
  }
  return noisy;
}

}  // namespace symscene
