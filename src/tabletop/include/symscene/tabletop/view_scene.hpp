#pragma once

#include "symscene/core/stage_timer.hpp"
#include "symscene/tabletop/scene_building.hpp"
#include "symscene/tabletop/view_points.hpp"

namespace symscene {

/// The options of view_scene().
struct ViewSceneOptions {
  ViewPointOptions points;
  OccupancyVolumeOptions occupancy;
  SceneBuildingOptions scene;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("points", self.points);
    visit("occupancy", self.occupancy);
    visit("scene", self.scene);
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// A depth image with its camera.
struct DepthView {
  const DepthFrame& frame;
  CameraIntrinsics camera;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
};

/// A scene from one depth image, in the world frame.
struct ViewScene {
  BuiltScene built;
  ViewPoints points;              ///< of the whole image, in the camera's frame
  OccupancyVolume occupancy;      ///< of the whole image
  std::vector<StageTime> stages;  ///< wall time
};

/// Makes a scene of a single depth image: its pixels become oriented points, the space before them
/// is free, and the space behind them and on rays without a measurement was never seen. The table
/// is searched as in build_scene(). Throws InputError if the image is not of the camera's size or
/// shows no surface, the pose is not rigid, or an option is out of range.
ViewScene view_scene(const DepthView& view, const TablePrior& known,
                     const ViewSceneOptions& options = {});

/// The same with what is known about the table from the camera's pose.
ViewScene view_scene(const DepthView& view, const ViewSceneOptions& options = {});

}  // namespace symscene
