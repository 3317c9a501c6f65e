#include "symscene/simulation/sensor_noise.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/geometry.hpp"

namespace symscene {
namespace {

/// Correlated normal noise of variance one: drawn on a grid and interpolated.
class GrainyNoise {
 public:
  GrainyNoise(const CameraIntrinsics& camera, double grain, Random& random)
      : grain_(grain), columns_(static_cast<std::size_t>(camera.width / grain) + 2) {
    const std::size_t rows = static_cast<std::size_t>(camera.height / grain) + 2;
    for (std::size_t i = 0; i < rows * columns_; ++i) values_.push_back(random.normal());
  }

  double at(Index u, Index v) const {
    const double x = u / grain_, y = v / grain_;
    const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
    const double fx = x - static_cast<double>(column), fy = y - static_cast<double>(row);
    const double* first = values_.data() + row * columns_ + column;
    const double* second = first + columns_;
    const double sum = (1 - fy) * ((1 - fx) * first[0] + fx * first[1]) +
                       fy * ((1 - fx) * second[0] + fx * second[1]);
    const double power = (fx * fx + (1 - fx) * (1 - fx)) * (fy * fy + (1 - fy) * (1 - fy));
    return sum / std::sqrt(power);  // interpolation lowers the variance between grid points
  }

 private:
  double grain_;
  std::size_t columns_;
  std::vector<double> values_;
};

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

void SensorNoiseOptions::validate() const {
  check_fields(*this);
  require_option(grazing_end > grazing_begin, "grazing_end", "more than grazing_begin",
                 grazing_end);
}

SensorFrame add_sensor_noise(const SensorFrame& exact, const CameraIntrinsics& camera,
                             const SensorNoiseOptions& options, Random random) {
  options.validate();
  if (!options.enabled) return exact;
  SensorFrame noisy = exact;
  const GrainyNoise noise(camera, options.grain, random);
  for (Index v = 0; v < camera.height; ++v) {
    for (Index u = 0; u < camera.width; ++u) {
      const std::size_t pixel = std::size_t{v} * camera.width + u;
      const std::size_t source = jittered_pixel(u, v, camera, options.lateral, random);
      const double z = exact.depth[source];
      const double angle = std::acos(std::min(1.0, static_cast<double>(exact.cosines[source])));
      const double lost =
          std::max(ramp(angle, options.grazing_begin, options.grazing_end),
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
