#pragma once

#include <memory>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/options.hpp"
#include "symscene/physics/grasp_world.hpp"
#include "symscene/robots/robot.hpp"

namespace symscene {

/// How the joints of an arm follow their targets. The controller knows the arm's masses, not those
/// of what the hand holds.
struct ArmWorldOptions {
  GraspWorldOptions contacts;
  double servo_frequency = 100.0;
  double armature = 0.1;
  double joint_force = 100.0;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("contacts", self.contacts);
    visit("servo_frequency", self.servo_frequency, "rad/s", above_up_to(0.0, 1000.0),
          "frequency of the critically damped control of each joint");
    visit("armature", self.armature, "kg m2", above(0.0),
          "inertia of each joint's drive, beside that of the links");
    visit("joint_force", self.joint_force, "Nm", above(0.0),
          "greatest torque of a joint, beside what holds the arm against gravity");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// What the links of a robot touch; the hand is not included.
struct ArmContacts {
  bool table = false;               ///< the table or a fixed box
  std::vector<std::size_t> bodies;  ///< ascending
  bool any() const { return table || !bodies.empty(); }
};

/// Rigid bodies on a table and a robot whose arm carries a parallel hand. The frame is that of the
/// table, as in GraspWorld. Links are their capsules with the density of water; they meet bodies,
/// the table and fixed boxes, but not each other. A link that reaches into the table in the home
/// configuration stands there: it meets neither the table nor fixed boxes. Bodies are absent at
/// first, fixed boxes take part, and the robot is at rest in its home configuration. The same calls
/// give the same poses to the last bit.
class ArmWorld {
 public:
  /// The hand is at T_tip_tool in the tip link of `arm`. Copies what it is given. Throws
  /// InputError if an option or a mass is out of its range, the bodies cannot be simulated, or
  /// this build has no physics.
  ArmWorld(std::span<const WeighedBody> bodies, const Robot& robot,
           const Eigen::Isometry3d& T_table_base, const Arm& arm,
           const Eigen::Isometry3d& T_tip_tool, const ParallelHand& hand,
           std::span<const FixedBox> fixed = {}, const ArmWorldOptions& options = {});
  ~ArmWorld();
  ArmWorld(ArmWorld&&) noexcept;
  ArmWorld& operator=(ArmWorld&&) noexcept;

  /// Puts the body at a pose, at rest; it may be in the world already.
  void put(std::size_t body, const Eigen::Isometry3d& T_table_body);
  /// Removes the body from the world until it is put back.
  void take_away(std::size_t body);
  bool is_there(std::size_t body) const;
  std::size_t size() const;
  /// T_table_body.
  Eigen::Isometry3d pose(std::size_t body) const;
  /// An upper bound of the speed of any point of the body. [m/s]
  double speed(std::size_t body) const;

  /// Puts all joints at these positions, at rest, with the hand open. Throws InputError unless
  /// there is one finite position per moving joint.
  void put_robot(const Eigen::VectorXd& positions);
  /// Sets what the joints follow: one position and one velocity per moving joint.
  void aim_robot(const Eigen::VectorXd& positions, const Eigen::VectorXd& velocities);
  /// Where all moving joints are.
  Eigen::VectorXd positions() const;
  /// T_table_tool.
  Eigen::Isometry3d hand_pose() const;

  /// Closes or opens the fingers with the hand's force.
  void close_fingers(bool on);
  /// Distance between the fingers. [m]
  double opening() const;
  HandContacts hand_contacts() const;
  ArmContacts arm_contacts() const;

  /// Simulates `seconds`, rounded to whole time steps. Throws PhysicsDiverged if the
  /// simulation diverges.
  void advance(double seconds);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace symscene
