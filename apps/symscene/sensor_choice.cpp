#include "sensor_choice.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "symscene/core/depth_noise.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene::app {
namespace {

double median_depth(const SensorEstimate& estimate) {
  return estimate.samples.empty() ? 1.0 : estimate.samples[estimate.samples.size() / 2].depth;
}

std::string found(const SensorEstimate& estimate) {
  if (estimate.too_little) return estimate.reason;
  return fmt::format(
      "noise of {:.1f} mm at 1 m that grows with depth^{:.1f}, correlation {:.2f} of neighbouring "
      "pixels",
      1e3 * estimate.deviation_at_1m, estimate.exponent, estimate.correlation);
}

std::string shown(const SensorEstimate& estimate, bool is_named) {
  if (!is_named) return found(estimate);
  return (estimate.too_little ? "named; " : "named; the frames show ") + found(estimate);
}

std::string json_of(const SensorEstimate& estimate, const SensorChoice& choice, bool is_named) {
  nlohmann::ordered_json object = {
      {"sensor", choice.sensor ? to_string(*choice.sensor) : "unknown"}, {"named", is_named}};
  object["found"] = estimate.sensor ? to_string(*estimate.sensor) : "unknown";
  if (!estimate.reason.empty()) object["reason"] = estimate.reason;
  if (!estimate.too_little) {
    object["exponent"] = estimate.exponent;
    object["deviation_at_1m"] = estimate.deviation_at_1m;
    object["correlation"] = estimate.correlation;
  }
  object["step"] = estimate.step;
  nlohmann::ordered_json samples = nlohmann::ordered_json::array();
  for (const DepthNoiseSample& sample : estimate.samples) {
    samples.push_back(
        {{"depth", sample.depth}, {"deviation", sample.deviation}, {"patches", sample.patches}});
  }
  object["samples"] = std::move(samples);
  if (choice.noise) object["noise"] = *choice.noise;
  if (choice.tracking_noise) object["tracking_noise"] = *choice.tracking_noise;
  object["flying_pixels_removed"] = choice.sensor == Sensor::time_of_flight;
  return object.dump();
}

std::string used(const SensorChoice& choice) {
  std::string noise = "the noise of the options";
  if (choice.noise) {
    noise = fmt::format("noise of {:.3g} z^2", *choice.noise);
  } else if (choice.tracking_noise) {
    noise = fmt::format("noise of {:.3g} z^2 in tracking and fusion", *choice.tracking_noise);
  }
  return choice.sensor == Sensor::time_of_flight ? noise + ", flying pixels removed" : noise;
}

}  // namespace

std::vector<DepthFrame> some_frames(const DepthSequence& sequence, int count) {
  std::vector<DepthFrame> frames;
  for (const Index i : evenly_spread(static_cast<Index>(sequence.size()), Index(count))) {
    try {
      frames.push_back(sequence.read(i));
    } catch (const InputError&) {
    }
  }
  return frames;
}

DepthFrame SensorChoice::prepared(DepthFrame frame, const CameraIntrinsics& camera) const {
  if (sensor != Sensor::time_of_flight) return frame;
  return without_flying_pixels(std::move(frame), camera, options.flying_step);
}

void SensorArguments::add_to(Arguments& arguments) {
  arguments.choice(
      "--sensor", name, {"auto", "structured-light", "stereo", "tof"},
      "depth sensor. A named one sets the noise of all stages: that of stereo follows from the "
      "camera; tof has at least that of structured-light and loses its flying pixels. auto, the "
      "default, says what the frames show and keeps the noise of the options, but where the frames "
      "of a sequence show noisy stereo it tracks with that noise");
}

SensorChoice SensorArguments::choose(std::span<const DepthFrame> frames, bool tracked,
                                     const CameraIntrinsics& camera, const DepthUse& depths,
                                     const SensorEstimationOptions& options,
                                     Session& session) const {
  if (const auto warning = depth_range_warning(frames, depths)) session.warn(*warning);
  SensorChoice choice;
  choice.options = options;
  const SensorEstimate estimate = estimate_sensor(frames, camera, options);
  const bool named = is_named();
  choice.sensor = named ? parse_sensor(name) : estimate.sensor;
  const double depth = median_depth(estimate);
  if (named) choice.noise = depth_noise(*choice.sensor, camera, depth, options);
  choice.tracking_noise = choice.noise;
  const bool is_noisy_stereo =
      estimate.sensor == Sensor::stereo && estimate.deviation_at_1m > structured_light_noise;
  if (tracked && !named && is_noisy_stereo)
    choice.tracking_noise = depth_noise(Sensor::stereo, camera, depth, options);
  choice.json = json_of(estimate, choice, named);
  session.print_line(fmt::format("sensor {}: {}; used: {}",
                                 choice.sensor ? to_string(*choice.sensor) : "unknown",
                                 shown(estimate, named), used(choice)));
  if (!named && !estimate.sensor && !estimate.too_little)
    session.warn(
        fmt::format("{}: {} (--sensor names the sensor)", estimate.reason, found(estimate)));
  return choice;
}

}  // namespace symscene::app
