#pragma once

#include <memory>
#include <optional>
#include <string>

#include "arguments.hpp"
#include "scene_output.hpp"
#include "sensor_choice.hpp"
#include "session.hpp"
#include "symscene/reconstruction/reconstruction.hpp"

namespace symscene::app {

/// The frames of a moving camera as the command line names them: the sequence and its camera, how
/// its poses are used, its sensor, and where the table is.
struct SweepArguments {
  std::filesystem::path path;
  SequenceOptions source;
  std::string poses;  ///< of --poses: "exact", "start", or empty to find them
  std::optional<int> every;
  TableArguments table;
  SensorArguments sensor;

  /// Adds --intrinsics, --depth-scale, --every, --poses, and those of table and sensor.
  void add_to(Arguments& arguments);

  std::size_t step() const { return static_cast<std::size_t>(every.value_or(1)); }

  /// Every step()-th frame of the sequence. Warns of its limitations. Throws InputError as
  /// open_sequence(), and if its poses are to be used and it has none.
  std::unique_ptr<DepthSequence> open(Session& session) const;

  /// Says what sensor the frames show, as SensorArguments::choose().
  ReportedSensor choose_sensor(const DepthSequence& sequence, const MeasurementOptions& measurement,
                               const SensorEstimationOptions& options, Session& session) const;

  bool uses_poses() const { return !poses.empty(); }
  PoseUse pose_use() const { return poses == "exact" ? PoseUse::exact : PoseUse::start; }
  /// Of frame i, if poses are used and it has one.
  std::optional<Eigen::Isometry3d> given_pose(const DepthSequence& sequence, std::size_t i) const;
};

}  // namespace symscene::app
