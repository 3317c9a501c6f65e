#pragma once

#include "symscene/core/scene.hpp"
#include "symscene/simulation/occupancy_fusion.hpp"
#include "symscene/simulation/sensor_noise.hpp"
#include "symscene/simulation/tabletop.hpp"

namespace symscene {

/// How the camera goes around the table: the arc of section 2.2.
struct CameraArcOptions {
  int frames = 20;                   ///< along the arc, at most 64
  double arc = 2.0943951;            ///< horizontal angle of the arc, 120° [rad]
  double radius = 1.0;               ///< distance to the point looked at [m]
  double min_elevation = 0.6108652;  ///< lowest above the table, 35° [rad]
  double max_elevation = 0.8726646;  ///< highest above the table, 50° [rad]
  double target_height = 0.06;       ///< of the point looked at, over the table [m]
  int width = 640;                   ///< [px]
  int height = 480;                  ///< [px]
  double focal_length = 525.0;       ///< [px]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("frames", self.frames, "", "frames along the arc, at most 64");
    visit("arc", self.arc, "rad", "horizontal angle of the arc");
    visit("radius", self.radius, "m", "distance to the point looked at");
    visit("min_elevation", self.min_elevation, "rad", "lowest elevation above the table");
    visit("max_elevation", self.max_elevation, "rad", "highest elevation above the table");
    visit("target_height", self.target_height, "m", "height of the point looked at");
    visit("width", self.width, "px", "width of the images");
    visit("height", self.height, "px", "height of the images");
    visit("focal_length", self.focal_length, "px", "focal length");
  }
  void validate() const;

  CameraIntrinsics intrinsics() const;
};

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
