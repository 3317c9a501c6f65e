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

  PickChecks& operator+=(const PickChecks& other);
};

/// Whether checks against meshes are built in (FCL).
bool checks_meshes();

/// Checks every motion of a pick against the limits of the joints. The motion to the pre-grasp and
/// the approach, both with open gripper, are checked against the true meshes too: capsules of the
/// links that the arm moves and boxes of the gripper, by FCL. On the approach the object that is
/// nearest to the tool at the grasp may be touched. `options`: those of the plan.
PickChecks check_pick(const PickMotion& motion, const Robot& robot, const RobotArm& arm,
                      const Gripper& gripper, const Tabletop& tabletop, const PickOptions& options);

}  // namespace symscene::bench
