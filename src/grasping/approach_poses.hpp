#pragma once

#include <vector>

#include "closing_lines.hpp"

namespace symscene {

/// A pose at which the gripper closes along a line, and its height over the table there. [m]
struct ApproachPose {
  Eigen::Isometry3d T_world_tool;
  GraspSource source;
  double table_clearance;
};

/// Shallow and deep poses from all directions across the line within `max_tilt`; of a three-finger
/// gripper also those that are turned by half a turn. A grasp is made shallower to clear the table,
/// down to `min_overhang`; if that is not enough its clearance is below the bound.
std::vector<ApproachPose> approach_poses(const GraspTarget& target, const ClosingLine& line,
                                         const Gripper& gripper, const std::optional<Plane>& table,
                                         const GraspOptions& options);

}  // namespace symscene
