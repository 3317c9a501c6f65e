#pragma once

#include <span>
#include <string>

#include "symscene/physics/grasp_world.hpp"

// Texts in MJCF that worlds with a hand share.
namespace symscene {

/// Options of the simulation and of contacts of so many bodies and a hand. Opens the tag <mujoco>.
std::string describe_options(std::size_t bodies, const GraspWorldOptions& options);

/// The hulls of all bodies and of the hand.
std::string describe_assets(std::span<const WeighedBody> bodies, const ParallelHand& hand);
/// The table, fixed boxes that take no part yet, and free bodies, in this order.
std::string describe_bodies(std::span<const WeighedBody> bodies, std::span<const FixedBox> fixed,
                            const GraspWorldOptions& options);

/// Palm and fingers as one body with two children; the joints of the fingers are "left" and
/// "right". `place` holds the attributes of the palm's pose.
std::string describe_palm(const ParallelHand& hand, const GraspWorldOptions& options,
                          const std::string& place = {});
/// What makes the fingers move by the same distance.
std::string describe_finger_coupling();
/// The actuators of both fingers. Their control is the finger's distance from the closed hand.
std::string describe_finger_actuators(const ParallelHand& hand);

/// The control that closes the fingers with their full force.
double closing_control();

}  // namespace symscene
