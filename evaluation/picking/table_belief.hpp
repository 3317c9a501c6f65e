#pragma once

#include <optional>
#include <vector>

#include "symscene/grasping/planner.hpp"
#include "symscene/picking/pick_run.hpp"
#include "symscene/picking/simulated_pick_options.hpp"

namespace symscene {

/// What the robot believes to stand on the table. Frame of the table.
struct TableBelief {
  GraspScene scene;
  std::vector<Grasp> grasps;                ///< best first
  std::vector<ObjectGraspSummary> objects;  ///< one per object of the scene
  std::vector<std::string> labels;          ///< the same: what it is taken for
};

/// The scene of images and its objects; both are empty if no table was found.
struct PerceivedScene {
  Scene scene;
  SegmentationResult result;
};

/// Turns the images of a look into a belief. The pose of the first image is the arm's; for all
/// others tracking corrects the arm's pose.
class TablePerception {
 public:
  /// The options are kept.
  explicit TablePerception(const SimulatedPickOptions& options);

  /// `by_arm`: the pose of the camera by the arm's joints. `truth`: the true one, with which that
  /// which is found is compared.
  void add(const DepthFrame& frame, const Eigen::Isometry3d& by_arm,
           const Eigen::Isometry3d& truth);
  /// Reconstructs the surface and finds table and objects, by the images so far.
  const PerceivedScene& perceived();
  /// The same, and plans grasps.
  TableBelief finish(const Gripper& gripper);
  /// Frames, errors and wall times so far.
  PickLook look() const;
  /// Wall times of what the robot computes.
  StageTimer& timer() { return timer_; }

 private:
  Scene build();

  const SimulatedPickOptions& options_;
  Reconstruction reconstruction_;
  std::size_t frames_ = 0;
  std::vector<Eigen::Isometry3d> estimated_, truth_;
  StageTimer timer_;
  std::optional<PerceivedScene> perceived_;  ///< of the images so far, once it was asked for
};

}  // namespace symscene
