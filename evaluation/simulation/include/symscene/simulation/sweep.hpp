#pragma once

#include <functional>
#include <string>

#include "symscene/core/depth_frame.hpp"
#include "symscene/simulation/camera_errors.hpp"
#include "symscene/simulation/camera_path.hpp"
#include "symscene/simulation/sensor_frame.hpp"
#include "symscene/simulation/sensor_noise.hpp"
#include "symscene/simulation/settling.hpp"

namespace symscene {

/// A depth camera carried around a table with objects.
struct SweepOptions {
  TabletopOptions tabletop;
  DropOptions drop;
  CameraArcOptions camera = {.frames = 200, .radius = 0.8};
  HandShakeOptions shake;
  SensorNoiseOptions sensor;
  CameraErrorOptions errors;
  double frame_rate = 30.0;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("tabletop", self.tabletop);
    visit("drop", self.drop);
    visit("camera", self.camera);
    visit("shake", self.shake);
    visit("sensor", self.sensor);
    visit("errors", self.errors);
    visit("frame_rate", self.frame_rate, "1/s", above(0.0), "frames per second");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// Receives the frames of a sweep in order, one at a time.
using FrameSink =
    std::function<void(const DepthFrame& frame, const Eigen::Isometry3d& T_world_camera)>;

/// Renders the frames with sensor noise in parallel and passes them to `sink` in order. Memory
/// holds two frames more than there are threads. The same options give the same frames for any
/// number of threads. Throws InputError if an option is out of range.
void capture_sweep(const Tabletop& tabletop, const SweepOptions& options, const FrameSink& sink);

/// Takes the time of a frame, what the camera measured, and the object that each pixel shows: its
/// index in the tabletop, or a greater one for all else.
using SensorFrameSink = std::function<void(double time, SensorFrame&& frame)>;

/// The same frames with what each pixel shows. Throws as capture_sweep() does.
void capture_sensor_frames(const Tabletop& tabletop, const SweepOptions& options,
                           const SensorFrameSink& sink);

/// A unique name for the mesh of each object: the object's name, with a number where it is taken.
std::vector<std::string> mesh_names(const Tabletop& tabletop);

/// The ground truth of a tabletop: the table, and the mesh, pose and symmetries of every object. No
/// masks. World frame.
SceneTruth tabletop_truth(const Tabletop& tabletop);

}  // namespace symscene
