#pragma once

#include <string>

#include "arm_cell.hpp"

namespace symscene {

/// Remembers the first thing that a moving robot touches and should not.
class ContactWatch {
 public:
  /// `cell` is kept. A robot that touches the table already stands on it.
  explicit ContactWatch(const ArmCell& cell)
      : cell_(cell), stands_on_table_(cell.world().arm_contacts().table) {}

  /// What the arm touches, and with `with_hand` also the hand: that of an arm that holds nothing.
  void note(bool with_hand);
  /// "the arm touched cup"; empty if nothing was touched.
  const std::string& touched() const { return touched_; }

 private:
  const ArmCell& cell_;
  bool stands_on_table_;
  std::string touched_;
};

/// Moves an arm that holds nothing along a path; what it touches is noted.
void follow_watched(ArmCell& cell, const Arm& arm, const TimedPath& path, ContactWatch& watch);

}  // namespace symscene
