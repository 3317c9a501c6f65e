#pragma once

#include <vector>

#include "closing_lines.hpp"

namespace symscene {

/// A pose at which the gripper closes along a line, and its height over the table. [m]
struct ApproachPose {
  Eigen::Isometry3d T_world_tool;
  GraspSource source;
  double table_clearance;
};

/// Poses from all directions across the line that do not come from below, shallow and deep. Where a
/// finger would reach into the table the grasp is shallower, but not by more than the options
/// allow: such a pose has too little clearance.
std::vector<ApproachPose> approach_poses(const GraspTarget& target, const ClosingLine& line,
                                         const Gripper& gripper, const std::optional<Plane>& table,
                                         const GraspOptions& options);

}  // namespace symscene
