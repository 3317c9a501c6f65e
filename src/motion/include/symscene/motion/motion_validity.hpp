#pragma once

#include "symscene/motion/arm_collision.hpp"
#include "symscene/motion/rrt_connect.hpp"

namespace symscene {

/// What rrt_connect() asks about configurations and straight motions of an arm: contacts are
/// described, ignored obstacles count as free. Keeps a reference to `arm`.
MotionValidity motion_validity(const ArmCollision& arm, const IgnoredObstacles& ignored = {});

}  // namespace symscene
