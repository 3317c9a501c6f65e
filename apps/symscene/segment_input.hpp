#pragma once

#include "scene_output.hpp"
#include "sensor_choice.hpp"
#include "symscene/workflow/scene_input.hpp"
#include "symscene/workflow/segment_options.hpp"

namespace symscene::app {

/// A scene, and what the page shows around its objects.
struct SegmentInput {
  Scene scene;
  TriangleMesh surface;             ///< may be empty
  Trajectory trajectory;            ///< may be empty
  std::vector<StageTime> stages;    ///< wall time of making the scene
  std::optional<DepthFrame> frame;  ///< of a scene that was made of one, in its camera's frame
  CameraIntrinsics camera;          ///< of the frame
  ReportedSensor sensor;            ///< of the frame
};

/// Where `symscene segment` finds its scene.
struct SegmentSource {
  std::filesystem::path path;
  SequenceOptions sequence;
  TableArguments table;
  SensorArguments sensor;
  std::string units;  ///< of a cloud: "m" or "mm"; empty for metres

  /// Adds the options of a scene that is made of a cloud or a depth image.
  void add_to(Arguments& arguments);

  /// Reads a scene folder, or makes a scene of a cloud or of a sequence of one depth image. Throws
  /// InputError if the path is none of these or cannot be read, or if an option has no effect on
  /// it.
  SegmentInput read(const SegmentOptions& options, Session& session) const;

  /// Whether the path is a scene folder or a cloud, which have no depth image.
  bool is_cloud() const;

  /// Throws InputError if an option is given that only depth images have a use for.
  void require_no_camera(const char* kind) const;

  /// Throws InputError if --units is given, which only clouds have a use for.
  void require_no_units() const;

 private:
  SegmentInput read_folder(const SegmentOptions& options, Session& session) const;
  bool may_hold_table() const;
  void crop_table(Scene& scene, const SegmentOptions& options, Session& session) const;
  SegmentInput read_cloud_file(const SegmentOptions& options, Session& session) const;
  SegmentInput read_view(const SegmentOptions& options, Session& session) const;
};

}  // namespace symscene::app
