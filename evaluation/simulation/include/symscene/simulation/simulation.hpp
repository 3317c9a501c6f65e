#pragma once

#include "symscene/core/scene.hpp"
#include "symscene/ground_truth/scene_truth.hpp"
#include "symscene/simulation/camera_path.hpp"
#include "symscene/simulation/occupancy_fusion.hpp"
#include "symscene/simulation/sensor_noise.hpp"
#include "symscene/simulation/tabletop.hpp"

namespace symscene {

struct SimulationOptions {
  TabletopOptions tabletop;
  CameraArcOptions camera;
  SensorNoiseOptions sensor;
  CloudFusionOptions cloud;
  OccupancyFusionOptions occupancy;
  double margin = 0.2;
  double table_clearance = 0.005;
  int min_object_points = 100;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("tabletop", self.tabletop);
    visit("camera", self.camera);
    visit("sensor", self.sensor);
    visit("cloud", self.cloud);
    visit("occupancy", self.occupancy);
    visit("margin", self.margin, "m", at_least(0.0),
          "width of the mapped space around and above the objects");
    visit("table_clearance", self.table_clearance, "m", at_least(0.0),
          "height above the table below which points belong to it");
    visit("min_object_points", self.min_object_points, "", at_least(1),
          "least points at 5 mm of an object in the ground truth");
  }
  /// Throws InputError if a value is out of its range or there are more than 64 frames.
  void validate() const;
};

/// A scene, its ground truth, and the tabletop that it shows.
struct SimulatedScene {
  Scene scene;
  SceneTruth truth;
  Tabletop tabletop;
  PointIndices sources;  ///< per object of the ground truth its number in the tabletop
};

/// The noisy images along the camera's arc around a tabletop. Mesh k is object k; the table is the
/// mesh after the last object. Throws InputError if an option is out of range.
std::vector<SensorFrame> capture_frames(const Tabletop& tabletop, const SimulationOptions& options);

/// Fuses the frames with their known poses into a scene with ground truth. Throws InputError if an
/// option is out of range.
SimulatedScene fuse_frames(const Tabletop& tabletop, std::span<const SensorFrame> frames,
                           const SimulationOptions& options);

/// Arranges a random tabletop and scans it with a simulated depth camera. The same options give the
/// same bytes for any number of threads. Throws InputError if an option is out of range.
SimulatedScene simulate_tabletop(const SimulationOptions& options);

}  // namespace symscene
