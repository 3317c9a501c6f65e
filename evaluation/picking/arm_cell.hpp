#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pick_bin.hpp"
#include "robots/robot_solids.hpp"
#include "symscene/motion/trajectory.hpp"
#include "symscene/physics/arm_world.hpp"
#include "symscene/picking/pick_table.hpp"

namespace symscene {

/// A robot before a table with objects, and a bin, in physics. Frame of the table, which is the
/// world of the robot.
class ArmCell {
 public:
  /// Called after each step of control.
  using OnStep = std::function<void(const ArmCell&)>;

  /// Puts the objects where they are and waits until they rest. References are kept. Throws
  /// InputError if an object has no volume, or this build has no physics, and PhysicsDiverged.
  ArmCell(const PickTable& table, const Robot& robot, const RobotArm& arm, const Gripper& gripper,
          const PickBin& bin, const SimulatedPickOptions& options, OnStep on_step);

  /// Moves an arm along a path until its end, or until `stop` holds. The difference between where
  /// the arm is meant to be and the start of the path fades along the way. Returns whether the end
  /// was reached.
  bool follow(const Arm& arm, const TimedPath& path, const std::function<bool()>& stop = {});
  void wait(double seconds);
  void close_fingers(bool on) { world_->close_fingers(on); }
  /// Waits until the objects rest, and removes those that have left the table. Returns their
  /// numbers.
  std::vector<std::size_t> settle();
  /// Removes the objects above the bin. Returns their numbers.
  std::vector<std::size_t> empty_bin();

  double time() const { return time_; }  ///< simulated [s]
  /// Positions of all joints that the arm was last told to take: what planning starts from.
  const Eigen::VectorXd& target() const { return target_; }
  RobotState state() const { return {world_->positions(), world_->opening()}; }
  const ArmWorld& world() const { return *world_; }

  /// Numbers of the objects on the table, ascending, and the table with these objects as they are.
  std::vector<std::size_t> present() const;
  Tabletop tabletop() const;
  const PlacedObject& object(std::size_t i) const { return table_.tabletop.objects[i]; }
  /// T_table_object, the last one if it was removed.
  const Eigen::Isometry3d& pose(std::size_t i) const { return poses_[i]; }
  std::size_t objects() const { return poses_.size(); }

 private:
  void aim(const Eigen::VectorXd& positions, const Eigen::VectorXd& velocities);
  void step();
  Eigen::Vector3d middle_of(std::size_t i) const;
  bool is_off_table(std::size_t i) const;

  const PickTable& table_;
  const PickBin& bin_;
  const SimulatedPickOptions& options_;
  OnStep on_step_;
  std::optional<ArmWorld> world_;
  std::vector<Eigen::Isometry3d> poses_;
  Eigen::VectorXd target_;
  double time_ = 0.0;
};

}  // namespace symscene
