#include "sensor_choice.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace symscene::app {
namespace {

std::string found(const SensorEstimate& estimate) {
  if (estimate.too_little) return estimate.reason;
  return fmt::format(
      "noise of {:.1f} mm at 1 m that grows with depth^{:.1f}, correlation {:.2f} of neighbouring "
      "pixels",
      1e3 * estimate.deviation_at_1m, estimate.exponent, estimate.correlation);
}

std::string shown(const SensorChoice& choice) {
  const SensorEstimate& estimate = choice.estimate;
  if (!choice.is_named) return found(estimate);
  return (estimate.too_little ? "named; " : "named; the frames show ") + found(estimate);
}

std::string json_of(const SensorChoice& choice) {
  const SensorEstimate& estimate = choice.estimate;
  nlohmann::ordered_json object = {
      {"sensor", choice.sensor ? to_string(*choice.sensor) : "unknown"},
      {"named", choice.is_named}};
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

void SensorArguments::add_to(Arguments& arguments) {
  arguments.choice(
      "--sensor", name, {"auto", "structured-light", "stereo", "tof"},
      "depth sensor. A named one sets the noise of all stages: that of stereo follows from the "
      "camera; tof has at least that of structured-light and loses its flying pixels. auto, the "
      "default, says what the frames show and keeps the noise of the options, but where the frames "
      "of a sequence show noisy stereo it tracks with that noise");
}

ReportedSensor SensorArguments::choose(std::span<const DepthFrame> frames, bool tracked,
                                       const CameraIntrinsics& camera, const DepthUse& depths,
                                       const SensorEstimationOptions& options,
                                       Session& session) const {
  if (const auto warning = depth_range_warning(frames, depths)) session.warn(*warning);
  const SensorChoice choice = choose_sensor(frames, tracked, camera, named_sensor(name), options);
  const SensorEstimate& estimate = choice.estimate;
  session.print_line(fmt::format("sensor {}: {}; used: {}",
                                 choice.sensor ? to_string(*choice.sensor) : "unknown",
                                 shown(choice), used(choice)));
  if (!choice.is_named && !estimate.sensor && !estimate.too_little)
    session.warn(
        fmt::format("{}: {} (--sensor names the sensor)", estimate.reason, found(estimate)));
  return {choice, json_of(choice)};
}

ReportedSensor SensorArguments::choose(const DepthSequence& sequence, bool tracked,
                                       const DepthUse& depths,
                                       const SensorEstimationOptions& options,
                                       Session& session) const {
  const SomeFrames some = some_frames(sequence, options.frames);
  for (const std::string& error : some.unreadable)
    session.warn(fmt::format("{}; the noise is looked at without it", error));
  return choose(some.frames, tracked, sequence.camera(), depths, options, session);
}

}  // namespace symscene::app
