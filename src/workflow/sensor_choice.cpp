#include "symscene/workflow/sensor_choice.hpp"

#include <utility>

#include "symscene/core/depth_noise.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {
namespace {

/// A depth at which the noise was looked at. [m]
double median_depth(const SensorEstimate& estimate) {
  return estimate.samples.empty() ? 1.0 : estimate.samples[estimate.samples.size() / 2].depth;
}

}  // namespace

DepthFrame SensorChoice::prepared(DepthFrame frame, const CameraIntrinsics& camera) const {
  if (sensor != Sensor::time_of_flight) return frame;
  return without_flying_pixels(std::move(frame), camera, options.flying_step);
}

std::optional<Sensor> named_sensor(const std::string& name) {
  if (name.empty() || name == "auto") return std::nullopt;
  return parse_sensor(name);
}

SensorChoice choose_sensor(std::span<const DepthFrame> frames, bool tracked,
                           const CameraIntrinsics& camera, std::optional<Sensor> named,
                           const SensorEstimationOptions& options) {
  SensorChoice choice;
  choice.options = options;
  choice.is_named = named.has_value();
  choice.estimate = estimate_sensor(frames, camera, options);
  const SensorEstimate& estimate = choice.estimate;
  choice.sensor = named ? named : estimate.sensor;
  const double depth = median_depth(estimate);
  if (named) choice.noise = depth_noise(*named, camera, depth, options);
  choice.tracking_noise = choice.noise;
  const bool is_noisy_stereo =
      estimate.sensor == Sensor::stereo && estimate.deviation_at_1m > structured_light_noise;
  if (tracked && !named && is_noisy_stereo)
    choice.tracking_noise = depth_noise(Sensor::stereo, camera, depth, options);
  return choice;
}

SomeFrames some_frames(const DepthSequence& sequence, int count) {
  SomeFrames some;
  for (const Index i : evenly_spread(static_cast<Index>(sequence.size()), Index(count))) {
    try {
      some.frames.push_back(sequence.read(i));
    } catch (const InputError& error) {
      some.unreadable.emplace_back(error.what());
    }
  }
  return some;
}

}  // namespace symscene
