#pragma once

#include <cstddef>

#include "symscene/motion/pick.hpp"
#include "symscene/simulation/tabletop.hpp"

namespace symscene::bench {

/// States of trajectories at 1 kHz, and how many of them violate what.
struct PickChecks {
  std::size_t states = 0;
  std::size_t positions = 0;      ///< with a joint outside its limits
  std::size_t velocities = 0;     ///< with a joint that is too fast
  std::size_t accelerations = 0;  ///< with an acceleration above the limit
  std::size_t objects = 0;        ///< in which a link or the gripper meets a true mesh
  std::size_t held = 0;           ///< in which the held object's true mesh meets another

  PickChecks& operator+=(const PickChecks& other);
};

/// Whether checks against meshes are built in (FCL).
bool checks_meshes();

/// Checks every motion of a pick against the limits of the joints, and by FCL against the true
/// meshes: capsules of the links that the arm moves and boxes of the gripper, open on the way there
/// and at `opening` [m] on the retreat. From the approach on, the object with most of its
/// surface between the fingers at the grasp may be touched. On the retreat it moves with the tool
/// and is checked against the other objects; those that it touches where it stands are left out.
/// `options`: those of the plan.
PickChecks check_pick(const PickMotion& motion, const Robot& robot, const RobotArm& arm,
                      const Gripper& gripper, double opening, const Tabletop& tabletop,
                      const PickOptions& options);

}  // namespace symscene::bench
