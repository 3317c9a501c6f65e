#pragma once

#include <memory>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/options.hpp"
#include "symscene/physics/parallel_hand.hpp"

namespace symscene {

/// A solid that can be grasped.
struct WeighedBody {
  const ConvexParts* parts = nullptr;  ///< in the body's frame
  double mass = 0.0;                   ///< [kg]
};

/// A box that does not move, such as a wall of a tray.
struct FixedBox {
  Eigen::Vector3d min = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d max = Eigen::Vector3d::Zero();  ///< [m]
};

/// What a hand touches.
struct HandContacts {
  bool table = false;               ///< the table or a fixed box
  double table_depth = 0.0;         ///< to which the hand reaches into them [m]
  std::vector<std::size_t> bodies;  ///< touched by the hand, ascending
  std::vector<double> depths;       ///< per touched body, to which the hand reaches into it [m]
  std::vector<std::size_t> held;    ///< touched by both fingers, ascending
  bool any() const { return table || !bodies.empty(); }
};

/// Coefficients of friction between bodies are those of the clutter-removal benchmark of VGN:
/// products of the coefficients of the two surfaces, where that of objects is 1.
struct GraspWorldOptions {
  double time_step = 0.002;
  double object_friction = 1.0;
  double table_friction = 0.5;
  double palm_friction = 0.5;
  double finger_friction = 1.0;
  double finger_torsional_friction = 0.1;
  double torsional_friction = 0.005;
  double rolling_friction = 0.0005;
  double hand_stiffness = 20000.0;
  double hand_force = 300.0;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("time_step", self.time_step, "s", between(1e-5, 0.01), "step of the integration");
    visit("object_friction", self.object_friction, "", above(0.0),
          "coefficient of friction between objects");
    visit("table_friction", self.table_friction, "", above(0.0),
          "coefficient of friction of the table and of fixed boxes");
    visit("palm_friction", self.palm_friction, "", above(0.0),
          "coefficient of friction of the palm");
    visit("finger_friction", self.finger_friction, "", above(0.0),
          "coefficient of friction of the fingers");
    visit("finger_torsional_friction", self.finger_torsional_friction, "m", above(0.0),
          "coefficient of friction of the fingers against turning about the contact normal");
    visit("torsional_friction", self.torsional_friction, "m", above(0.0),
          "coefficient of friction of other contacts against turning about the contact normal");
    visit("rolling_friction", self.rolling_friction, "m", above(0.0),
          "coefficient of friction against rolling");
    visit("hand_stiffness", self.hand_stiffness, "N/m", above(0.0),
          "force that pulls the palm to its target, over the distance");
    visit("hand_force", self.hand_force, "N", above(0.0), "its greatest value along each axis");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// Rigid bodies above a table and a parallel hand that flies. The world is the table's frame, as
/// that of PhysicsWorld: the table is the unbounded plane z = 0. The palm keeps its orientation and
/// is pulled to a target; the fingers move by the same distance. Bodies, fixed boxes and the hand
/// are absent at first. The same calls give the same poses to the last bit.
class GraspWorld {
 public:
  /// Copies what it is given. Throws InputError if an option or a mass is out of its range, the
  /// bodies cannot be simulated, or this build has no physics.
  GraspWorld(std::span<const WeighedBody> bodies, const ParallelHand& hand,
             std::span<const FixedBox> fixed = {}, const GraspWorldOptions& options = {});
  ~GraspWorld();
  GraspWorld(GraspWorld&&) noexcept;
  GraspWorld& operator=(GraspWorld&&) noexcept;

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
  /// Whether the body touches anything where it is now.
  bool touches(std::size_t body) const;

  /// Whether the fixed boxes take part.
  void show_fixed(bool on);

  /// Puts the open hand at a pose, at rest.
  void put_hand(const Eigen::Isometry3d& T_table_tool);
  void take_hand_away();
  /// Moves the target of the hand's origin.
  void pull_hand_to(const Eigen::Vector3d& target_table);
  /// Closes or opens the fingers with the hand's force.
  void close_fingers(bool on);
  /// Distance between the fingers. [m]
  double opening() const;
  /// T_table_tool.
  Eigen::Isometry3d hand_pose() const;

  /// What the hand touches where it is now.
  HandContacts hand_contacts() const;

  /// Simulates `seconds`, rounded to whole time steps. Throws PhysicsDiverged if the
  /// simulation diverges.
  void advance(double seconds);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace symscene
