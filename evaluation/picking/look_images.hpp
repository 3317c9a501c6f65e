#pragma once

#include <span>

#include "arm_cell.hpp"
#include "look_renderer.hpp"
#include "table_belief.hpp"

namespace symscene {

/// What a look showed besides its images.
struct TakenLook {
  double robot_share = 0.0;  ///< of the pixels, that the robot or the bin covered
  std::string touched;       ///< what the arm touched on its way; empty for nothing
  bool is_enough = false;    ///< no further view is expected to show much more
};

/// Takes the images of a run with the robot's camera. References are kept.
class LookImages {
 public:
  LookImages(const Robot& robot, const RobotSolids& solids, const TriangleMesh& bin,
             const SimulatedPickOptions& options)
      : robot_(robot), solids_(solids), bin_(bin), options_(options) {}

  /// Where the camera and the robot are now.
  CameraMoment moment(const ArmCell& cell) const;
  /// The same with a camera that flies.
  CameraMoment moment(const ArmCell& cell, const Eigen::Isometry3d& T_table_camera) const {
    return {cell.time(), T_table_camera, solids_.poses(cell.state())};
  }
  /// Renders the images of moments in which the table is as it is now, and passes them to
  /// `perception`, in order. Returns the sum of their robot_share.
  double add(const ArmCell& cell, std::span<const CameraMoment> moments,
             TablePerception& perception);

 private:
  Eigen::Isometry3d pose_by_arm(const Eigen::Isometry3d& truth, std::uint64_t image) const;

  const Robot& robot_;
  const RobotSolids& solids_;
  const TriangleMesh& bin_;
  const SimulatedPickOptions& options_;
  std::uint64_t images_ = 0;  ///< so far
};

}  // namespace symscene
