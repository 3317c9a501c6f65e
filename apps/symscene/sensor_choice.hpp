#pragma once

#include <optional>
#include <span>
#include <vector>

#include "arguments.hpp"
#include "depth_range.hpp"
#include "session.hpp"
#include "symscene/reconstruction/sensor.hpp"

namespace symscene::app {

/// The sensor that the command line names or the frames show.
struct SensorChoice {
  std::optional<Sensor> sensor;
  std::optional<double> noise;  ///< in place of the options' noise, if the sensor is named [1/m]
  std::optional<double> tracking_noise;  ///< the same of tracking and fusion, also of a stereo
                                         ///< camera that is found with more noise than usual [1/m]
  std::string json;                      ///< what was found and what is used
  SensorEstimationOptions options;

  /// The frame as the stages take it: of a time-of-flight camera without flying pixels.
  DepthFrame prepared(DepthFrame frame, const CameraIntrinsics& camera) const;
};

/// Frames that are spread over the sequence; those that cannot be read are left out.
std::vector<DepthFrame> some_frames(const DepthSequence& sequence, int count);

/// --sensor.
struct SensorArguments {
  std::string name;

  void add_to(Arguments& arguments);

  bool is_named() const { return !name.empty() && name != "auto"; }

  /// Looks at frames, which are to be tracked or not, says what it finds, and warns if no sensor
  /// explains it or if their depths suggest another scale.
  SensorChoice choose(std::span<const DepthFrame> frames, bool tracked,
                      const CameraIntrinsics& camera, const DepthUse& depths,
                      const SensorEstimationOptions& options, Session& session) const;
};

}  // namespace symscene::app
