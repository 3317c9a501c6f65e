#pragma once

#include <vector>

#include "robots/robot_solids.hpp"
#include "simulation/depth_renderer.hpp"
#include "symscene/core/depth_frame.hpp"
#include "symscene/picking/simulated_pick_options.hpp"
#include "symscene/simulation/tabletop.hpp"

namespace symscene {

/// Where the camera and the robot's solids are when an image is taken. Frame of the table.
struct CameraMoment {
  double time = 0.0;  ///< simulated [s]
  Eigen::Isometry3d T_table_camera = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Isometry3d> solids;
};

/// An image and the share of its pixels that the robot or the bin covered.
struct LookImage {
  DepthFrame frame;
  double robot_share = 0.0;
};

/// Images of a table with a robot before it. What shows the robot or the bin is left out: the robot
/// knows their shapes.
class LookRenderer {
 public:
  /// References are kept.
  LookRenderer(const Tabletop& tabletop, const RobotSolids& robot, const TriangleMesh& bin,
               const SimulatedPickOptions& options);

  /// The image of a moment with the sensor's noise; `stream` numbers the images of a run. May be
  /// called from many threads at once.
  LookImage render(const CameraMoment& moment, std::uint64_t stream) const;

 private:
  const RobotSolids& robot_;
  const TriangleMesh& bin_;
  const SimulatedPickOptions& options_;
  CameraIntrinsics camera_;
  DepthRenderer table_;
};

}  // namespace symscene
