#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact_watch.hpp"
#include "look_images.hpp"
#include "look_motion.hpp"

namespace symscene {

/// Looks at the table with the robot's camera: along a sweep, or from views that are chosen one by
/// one (SimulatedPickOptions::views). References are kept.
class LookTaker {
 public:
  /// A camera that no arm carries flies. Throws InputError as CameraArm does.
  LookTaker(const Robot& robot, const RobotSolids& solids, const Gripper& gripper,
            const PickBin& bin, const TriangleMesh& bin_mesh, const SimulatedPickOptions& options);

  bool is_flying() const { return !arm_; }
  /// Plans the motion; why there is none, else an empty text.
  std::string plan();
  /// Passes the images to `perception`, in order.
  TakenLook take(ArmCell& cell, TablePerception& perception);

 private:
  std::string plan_views();
  TakenLook fly(ArmCell& cell, TablePerception& perception);
  TakenLook fly_to_views(ArmCell& cell, TablePerception& perception);
  TakenLook move_to_views(ArmCell& cell, TablePerception& perception);

  const SimulatedPickOptions& options_;
  double azimuth_;  ///< of the robot's base [rad]
  LookImages images_;
  std::optional<CameraArm> arm_;
  std::optional<LookMotion> sweep_;
  std::vector<ViewStation> stations_;
};

}  // namespace symscene
