#pragma once

#include <span>

#include "mujoco_world.hpp"
#include "symscene/physics/grasp_world.hpp"

namespace symscene {

/// A world whose hand is three MuJoCo bodies in a row: the palm and the two fingers. They meet
/// bodies, the table and fixed boxes, but not each other.
struct WorldWithHand : MujocoWorld {
  ParallelHand hand;
  int palm = 0;             ///< MuJoCo's body
  int finger_position = 0;  ///< of the first of both fingers' joints in qpos
  int finger_velocity = 0;  ///< the same in qvel
  int finger_actuator = 0;  ///< the same in ctrl

  int finger(int k) const { return palm + 1 + k; }
  /// Throws InputError unless the hand is valid and all masses are above 0.
  static void require_valid(std::span<const WeighedBody> bodies, const ParallelHand& hand);
  /// Takes over the model, gives bodies and hand their masses, and takes all bodies away. The
  /// actuators of the fingers are the last ones.
  void begin(MujocoModel compiled, std::span<const WeighedBody> bodies, const ParallelHand& of);
  /// Whether the hand takes part in contacts.
  void show_hand(bool on) const;
  /// Whether the fixed boxes take part.
  void show_fixed(bool on) const;
  /// Opens the fingers at once, at rest.
  void hold_open() const;
  void close_fingers(bool on) const;
  double opening() const;
  bool touches(std::size_t body) const;
  HandContacts hand_contacts() const;

  /// Contacts of the present poses.
  void find_contacts() const;
  /// Calls visit(body, other body, depth) for both orders of each touching pair.
  template <class Visit>
  void for_each_contact(const Visit& visit) const {
    for (int c = 0; c < data->ncon; ++c) {
      const mjContact& contact = data->contact[c];
      if (contact.dist > 0.0) continue;
      const int a = model->geom_bodyid[contact.geom1], b = model->geom_bodyid[contact.geom2];
      visit(a, b, -contact.dist);
      visit(b, a, -contact.dist);
    }
  }
};

}  // namespace symscene
