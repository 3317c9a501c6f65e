#pragma once

#include "symscene/core/scene.hpp"
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
  double margin = 0.2;             ///< of mapped space around and above the objects [m]
  double table_clearance = 0.005;  ///< height under which points count as the table's [m]
  int min_object_points = 100;     ///< at 5 mm; the truth leaves out what shows fewer

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("tabletop", self.tabletop);
    visit("camera", self.camera);
    visit("sensor", self.sensor);
    visit("cloud", self.cloud);
    visit("occupancy", self.occupancy);
    visit("margin", self.margin, "m", "mapped space around and above the objects");
    visit("table_clearance", self.table_clearance, "m",
          "height under which points are the table's");
    visit("min_object_points", self.min_object_points, "",
          "points at 5 mm that the truth asks for");
  }
  void validate() const;
};

/// A scene, what is true of it, and what it was made from.
struct SimulatedScene {
  Scene scene;
  SceneTruth truth;
  Tabletop tabletop;
  PointIndices sources;  ///< for each object of the truth its place in the tabletop's objects
};

/// The noisy images of a camera's arc around a tabletop. The table is the mesh after the objects'.
std::vector<SensorFrame> capture_frames(const Tabletop& tabletop, const SimulationOptions& options);

/// What the frames show, fused with their known poses.
SimulatedScene fuse_frames(const Tabletop& tabletop, std::span<const SensorFrame> frames,
                           const SimulationOptions& options);

/// A random tabletop as a depth camera would have scanned it. The same options give the same bytes
/// for any number of threads.
SimulatedScene simulate_tabletop(const SimulationOptions& options);

}  // namespace symscene
