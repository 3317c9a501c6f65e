#pragma once

#include <string>

#include "symscene/reconstruction/reconstruction.hpp"
#include "symscene/reconstruction/trajectory_error.hpp"
#include "symscene/simulation/sweep.hpp"
#include "symscene/simulation/truth_transfer.hpp"
#include "symscene/tabletop/view_scene.hpp"

namespace symscene {

/// The stages that make a scene from a sweep.
struct SweptSceneOptions {
  ReconstructionOptions reconstruction;
  ViewPointOptions view;
  SceneBuildingOptions scene;
  TruthTransferOptions truth;
  std::string poses = "tracked";

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("reconstruction", self.reconstruction);
    visit("view", self.view);
    visit("scene", self.scene);
    visit("truth", self.truth);
    visit("poses", self.poses, "", any_value(),
          "poses of the frames: tracked or exact, for frames that are too far apart to be tracked");
  }
  /// Throws InputError if a value is out of its range or poses are neither tracked nor exact.
  void validate() const;
};

/// The scene reconstructed from a simulated sweep by tracking, its ground truth, and the error of
/// the reconstruction.
struct SweptScene {
  Scene scene;           ///< in the frame of the first camera that was fused
  SceneTruth truth;      ///< of what the scene's cloud shows, in the same frame
  TriangleMesh surface;  ///< the whole reconstruction, in the same frame
  Eigen::Isometry3d T_scene_world = Eigen::Isometry3d::Identity();  ///< of the sweep's world
  std::size_t frames = 0;
  std::size_t fused = 0;          ///< of the frames; others were lost
  TrajectoryError trajectory;     ///< of the fused frames; zero where they are fewer than two
  std::vector<StageTime> stages;  ///< wall time
};

/// Renders a sweep over a tabletop, reconstructs it with tracked or exact poses, finds the table
/// and transfers the ground truth to the reconstruction. The scene of a sweep of one frame is that
/// of view_scene(). If no frame is fused or no table is found, the scene and its ground truth are
/// empty. The result is the same for any number of threads. With a calibration, frames are
/// rectified by it first. Throws InputError if an option is out of its range.
SweptScene reconstruct_sweep(const Tabletop& tabletop, const SweepOptions& sweep,
                             const SweptSceneOptions& options = {},
                             const CameraModel* calibration = nullptr);

}  // namespace symscene
