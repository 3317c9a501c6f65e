#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "symscene/io/sequence.hpp"
#include "symscene/reconstruction/sensor.hpp"

namespace symscene {

/// The sensor that is named or that the frames show, and the noise that stages take from it.
struct SensorChoice {
  std::optional<Sensor> sensor = {};
  bool is_named = false;
  std::optional<double> noise = {};  ///< in place of the options' noise, if it is named [1/m]
  std::optional<double> tracking_noise = {};  ///< the same of tracking and fusion, also of a stereo
                                              ///< camera found with more noise than usual [1/m]
  SensorEstimate estimate = {};               ///< what the frames show
  SensorEstimationOptions options = {};

  /// The frame as the stages take it: of a time-of-flight camera without flying pixels.
  DepthFrame prepared(DepthFrame frame, const CameraIntrinsics& camera) const;
};

/// The sensor of that name; none for "auto" and an empty name. Throws InputError for other names.
std::optional<Sensor> named_sensor(const std::string& name);

/// Looks at frames, which are to be tracked or not. Throws InputError as estimate_sensor().
SensorChoice choose_sensor(std::span<const DepthFrame> frames, bool tracked,
                           const CameraIntrinsics& camera, std::optional<Sensor> named,
                           const SensorEstimationOptions& options = {});

/// Frames of a sequence.
struct SomeFrames {
  std::vector<DepthFrame> frames;
  std::vector<std::string> unreadable;  ///< the error of each frame that is left out
};

/// At most `count` frames that are spread over the sequence.
SomeFrames some_frames(const DepthSequence& sequence, int count);

}  // namespace symscene
