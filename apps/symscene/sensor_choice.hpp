#pragma once

#include <span>
#include <string>

#include "arguments.hpp"
#include "depth_range.hpp"
#include "session.hpp"
#include "symscene/workflow/sensor_choice.hpp"

namespace symscene::app {

/// The sensor that the command line names or the frames show.
struct ReportedSensor : SensorChoice {
  std::string json;  ///< what was found and what is used
};

/// --sensor.
struct SensorArguments {
  std::string name;

  void add_to(Arguments& arguments);

  bool is_named() const { return named_sensor(name).has_value(); }

  /// Looks at frames, which are to be tracked or not, says what it finds, and warns if no sensor
  /// explains it or if their depths suggest another scale.
  ReportedSensor choose(std::span<const DepthFrame> frames, bool tracked,
                        const CameraIntrinsics& camera, const DepthUse& depths,
                        const SensorEstimationOptions& options, Session& session) const;

  /// Looks at frames that are spread over the sequence.
  ReportedSensor choose(const DepthSequence& sequence, bool tracked, const DepthUse& depths,
                        const SensorEstimationOptions& options, Session& session) const;
};

}  // namespace symscene::app
