#pragma once

#include <optional>

#include "contact_watch.hpp"
#include "look_motion.hpp"
#include "look_renderer.hpp"
#include "table_belief.hpp"

namespace symscene {

/// What a look showed besides its images.
struct TakenLook {
  double robot_share = 0.0;  ///< of the pixels, that the robot or the bin covered
  std::string touched;       ///< what the arm touched on its way; empty for nothing
};

/// Moves the camera past the table and takes images. References are kept.
class LookTaker {
 public:
  /// `motion`: of the arm with the camera; nullptr: the camera flies.
  LookTaker(const Robot& robot, const RobotSolids& solids, const TriangleMesh& bin,
            const LookMotion* motion, const SimulatedPickOptions& options)
      : robot_(robot), solids_(solids), bin_(bin), motion_(motion), options_(options) {}

  /// Passes the images to `perception`, in order.
  TakenLook take(ArmCell& cell, TablePerception& perception);

 private:
  CameraMoment moment(const ArmCell& cell) const;
  std::vector<CameraMoment> move(ArmCell& cell, ContactWatch& watch) const;
  std::vector<CameraMoment> fly(const ArmCell& cell) const;
  Eigen::Isometry3d pose_by_arm(const Eigen::Isometry3d& truth, std::uint64_t image) const;

  const Robot& robot_;
  const RobotSolids& solids_;
  const TriangleMesh& bin_;
  const LookMotion* motion_;
  const SimulatedPickOptions& options_;
  std::uint64_t images_ = 0;
};

}  // namespace symscene
