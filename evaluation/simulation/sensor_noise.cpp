#include "symscene/simulation/sensor_noise.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sensor_models.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/geometry.hpp"

namespace symscene {
namespace {

/// Whether a row or column is missing from a depth image that was registered to a larger one.
bool is_missing_line(Index line, double spacing) {
  return std::floor((line + 1) / spacing) > std::floor(line / spacing);
}

void clear_missing_lines(SensorFrame& frame, const CameraIntrinsics& camera, double spacing) {
  for (Index v = 0; v < camera.height; ++v) {
    for (Index u = 0; u < camera.width; ++u) {
      if (is_missing_line(u, spacing) || is_missing_line(v, spacing))
        clear_pixel(frame, std::size_t{v} * camera.width + u);
    }
  }
}

SensorFrame measured_frame(const SensorFrame& exact, const CameraIntrinsics& camera,
                           const SensorNoiseOptions& options, const Random& random) {
  switch (parse_simulated_sensor(options.model)) {
    case SimulatedSensor::stereo:
      return stereo_frame(exact, camera, options, random);
    case SimulatedSensor::time_of_flight:
      return time_of_flight_frame(exact, camera, options, random);
    case SimulatedSensor::structured_light:
      break;
  }
  return structured_light_frame(exact, camera, options, random);
}

}  // namespace

const char* to_string(SimulatedSensor sensor) {
  switch (sensor) {
    case SimulatedSensor::stereo:
      return "stereo";
    case SimulatedSensor::time_of_flight:
      return "tof";
    case SimulatedSensor::structured_light:
      break;
  }
  return "structured-light";
}

SimulatedSensor parse_simulated_sensor(const std::string& text) {
  for (const SimulatedSensor sensor : {SimulatedSensor::structured_light, SimulatedSensor::stereo,
                                       SimulatedSensor::time_of_flight}) {
    if (text == to_string(sensor)) return sensor;
  }
  throw InputError("model", "structured-light, stereo or tof", fmt::format("\"{}\"", text));
}

void SensorNoiseOptions::validate() const {
  check_fields(*this);
  parse_simulated_sensor(model);
  require_option(grazing_end > grazing_begin, "grazing_end", "more than grazing_begin",
                 grazing_end);
  require_option(missing_lines == 0.0 || missing_lines >= 2.0, "missing_lines", "0 or at least 2",
                 missing_lines);
}

SensorFrame add_sensor_noise(const SensorFrame& exact, const CameraIntrinsics& camera,
                             const SensorNoiseOptions& options, Random random) {
  options.validate();
  if (!options.enabled) return exact;
  SensorFrame noisy = measured_frame(exact, camera, options, random);
  if (options.missing_lines > 0.0) clear_missing_lines(noisy, camera, options.missing_lines);
  return noisy;
}

void set_pixel(SensorFrame& noisy, std::size_t pixel, const SensorFrame& exact, std::size_t source,
               double z) {
  noisy.depth[pixel] = static_cast<float>(z);
  noisy.objects[pixel] = exact.objects[source];
  noisy.cosines[pixel] = exact.cosines[source];
  noisy.colors.row(static_cast<Eigen::Index>(pixel)) =
      exact.colors.row(static_cast<Eigen::Index>(source));
}

void clear_pixel(SensorFrame& noisy, std::size_t pixel) {
  noisy.depth[pixel] = 0.0F;
  noisy.objects[pixel] = SensorFrame::nothing;
}

double reflectance(const SensorFrame& frame, std::size_t pixel) {
  return frame.colors.row(static_cast<Eigen::Index>(pixel)).cast<double>().mean() / 255.0;
}

double grazing_loss(const SensorFrame& frame, std::size_t pixel,
                    const SensorNoiseOptions& options) {
  const double angle = std::acos(std::min(1.0, static_cast<double>(frame.cosines[pixel])));
  return ramp(angle, options.grazing_begin, options.grazing_end);
}

}  // namespace symscene
