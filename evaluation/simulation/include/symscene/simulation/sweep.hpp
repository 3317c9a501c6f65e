#pragma once

#include <functional>
#include <string>

#include "symscene/core/depth_frame.hpp"
#include "symscene/simulation/camera_path.hpp"
#include "symscene/simulation/sensor_noise.hpp"
#include "symscene/simulation/settling.hpp"

namespace symscene {

/// A table with objects that a depth camera is carried around.
struct SweepOptions {
  TabletopOptions tabletop;
  DropOptions drop;
  CameraArcOptions camera = {.frames = 200, .radius = 0.8};
  HandShakeOptions shake;
  SensorNoiseOptions sensor;
  double frame_rate = 30.0;  ///< [1/s]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("tabletop", self.tabletop);
    visit("drop", self.drop);
    visit("camera", self.camera);
    visit("shake", self.shake);
    visit("sensor", self.sensor);
    visit("frame_rate", self.frame_rate, "1/s", "frames a second");
  }
  void validate() const;
};

/// Receives the frames of a sweep in their order, one at a time.
using FrameSink =
    std::function<void(const DepthFrame& frame, const Eigen::Isometry3d& T_world_camera)>;

/// Renders the frames with the sensor's noise, in parallel but for the sink; no more are held than
/// threads need. The same options give the same frames for any number of threads.
void capture_sweep(const Tabletop& tabletop, const SweepOptions& options, const FrameSink& sink);

/// A name for each object's mesh that no other has: its own, and a number where that is taken.
std::vector<std::string> mesh_names(const Tabletop& tabletop);

/// What is true of a tabletop: the table, and every object with mesh, pose and symmetries. No
/// masks.
SceneTruth tabletop_truth(const Tabletop& tabletop);

}  // namespace symscene
