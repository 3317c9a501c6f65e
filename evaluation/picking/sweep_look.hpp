#pragma once

#include "look_images.hpp"
#include "look_motion.hpp"

namespace symscene {

/// Moves the arm's camera past the table along a planned motion and back, and passes evenly spaced
/// images of its middle part to `perception`.
TakenLook sweep_look(ArmCell& cell, const Arm& arm, const LookMotion& motion, int frames,
                     LookImages& images, TablePerception& perception);

}  // namespace symscene
