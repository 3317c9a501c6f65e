#pragma once

#include "symscene/core/gripper.hpp"
#include "symscene/physics/convex_parts.hpp"

namespace symscene {

/// A parallel hand as the physics sees it. Tool frame: the origin lies midway between the open
/// fingers where they leave the palm, z points to the fingertips, y is the direction in which the
/// fingers close.
struct ParallelHand {
  ConvexParts palm;    ///< in the tool frame [m]
  ConvexParts finger;  ///< of the closed hand, the one that opens along +y, in the tool frame [m].
                       ///< The other is turned by half a turn about z
  double max_opening = 0.0;  ///< distance between the open fingers [m]
  double palm_mass = 0.0;    ///< [kg]
  double finger_mass = 0.0;  ///< of each [kg]
  double force = 0.0;        ///< of each finger [N]
  double speed = 0.0;        ///< of each finger, while nothing is between them [m/s]

  /// Throws InputError if a value is not positive or a part is missing.
  void validate() const;
};

/// The hand of Franka Emika's Panda as the clutter-removal benchmark of VGN has it: the hulls of
/// its collision shapes, the tool frame 62 mm along z from the frame of the hand, fingertips 50 mm
/// beyond it.
ParallelHand panda_parallel_hand();

/// The palm and the tapering fingers of a gripper as boxes, with a palm of 0.8 kg and fingers of
/// 0.1 kg that move at 0.2 m/s. Throws InputError if the gripper is invalid or has three fingers.
ParallelHand parallel_hand_of(const Gripper& gripper);

}  // namespace symscene
