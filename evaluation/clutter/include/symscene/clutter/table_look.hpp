#pragma once

#include "symscene/core/scene.hpp"
#include "symscene/reconstruction/reconstruction.hpp"
#include "symscene/reconstruction/trajectory_error.hpp"
#include "symscene/simulation/sweep.hpp"
#include "symscene/tabletop/scene_building.hpp"

namespace symscene {

/// The stages that make a scene of a sweep.
struct TableLookOptions {
  ReconstructionOptions reconstruction;
  SceneBuildingOptions scene;
  bool exact_poses = false;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("reconstruction", self.reconstruction);
    visit("scene", self.scene);
    visit("exact_poses", self.exact_poses, "", any_value(),
          "take the poses of the frames from the simulation instead of tracking");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// What a sweep of a moving depth camera shows of a table.
struct TableLook {
  Scene scene;  ///< in the frame of the first fused camera; without points if nothing is on a table
  Eigen::Isometry3d T_world_scene =
      Eigen::Isometry3d::Identity();  ///< the true pose of that camera
  std::size_t frames = 0;
  std::size_t fused = 0;       ///< of the frames; others were lost
  TrajectoryError trajectory;  ///< of the fused frames
  double seconds = 0.0;        ///< wall time from depth images to the scene, without rendering
};

/// Renders a sweep over a tabletop, tracks and fuses its frames without their poses, and searches
/// the table. Only the pose of the first fused frame is taken from the simulation, to place the
/// scene in the world, unless exact_poses is set. Throws InputError if an option is out of its
/// range.
TableLook look_at_table(const Tabletop& tabletop, const SweepOptions& sweep,
                        const TableLookOptions& options = {});

}  // namespace symscene
