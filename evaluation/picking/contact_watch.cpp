#include "contact_watch.hpp"

namespace symscene {

void ContactWatch::note(bool with_hand) {
  if (!touched_.empty()) return;
  const ArmContacts arm = cell_.world().arm_contacts();
  if (!arm.bodies.empty())
    touched_ = "the arm touched " + cell_.object(arm.bodies.front()).object.name;
  else if (arm.table && !stands_on_table_)
    touched_ = "the arm touched the table or the bin";
  if (!with_hand || !touched_.empty()) return;
  const HandContacts hand = cell_.world().hand_contacts();
  if (!hand.bodies.empty())
    touched_ = "the empty hand touched " + cell_.object(hand.bodies.front()).object.name;
}

void follow_watched(ArmCell& cell, const Arm& arm, const TimedPath& path, ContactWatch& watch) {
  cell.follow(arm, path, [&] {
    watch.note(true);
    return false;
  });
}

}  // namespace symscene
