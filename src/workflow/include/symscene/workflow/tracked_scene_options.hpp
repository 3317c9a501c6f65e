#pragma once

#include "symscene/reconstruction/reconstruction.hpp"
#include "symscene/reconstruction/sensor.hpp"
#include "symscene/tabletop/scene_building.hpp"
#include "symscene/tabletop/view_points.hpp"

namespace symscene {

/// The options of a scene that is made of tracked frames: those of `symscene reconstruct` without
/// stitching.
struct TrackedSceneOptions {
  ReconstructionOptions reconstruction;
  ViewPointOptions view;  ///< of a single frame
  SceneBuildingOptions scene;
  SensorEstimationOptions sensor;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    ReconstructionOptions::visit_fields(self.reconstruction, visit);
    visit("view", self.view);
    visit("scene", self.scene);
    visit("sensor", self.sensor);
  }
  /// Throws InputError if a value is out of its range.
  void validate() const {
    reconstruction.validate();
    view.validate();
    scene.validate();
    sensor.validate();
  }
};

}  // namespace symscene
