#pragma once

#include <optional>
#include <vector>

#include "symscene/motion/joint_space.hpp"
#include "symscene/robots/inverse_kinematics.hpp"

namespace symscene {

/// How a tool is moved along a line.
struct StraightWay {
  double step;      ///< [m]
  double max_jump;  ///< of a joint per step [rad]
};

/// Joint positions along a straight way of the tip from `start`, whose pose is `T_base_tip`, by
/// `offset` in the base link's frame; the orientation stays. None if a joint has to jump or leave
/// its limits.
std::optional<std::vector<Eigen::VectorXd>> straight_way(
    const ArmChain& chain, const JointSpace& space, const Eigen::VectorXd& start,
    const Eigen::Isometry3d& T_base_tip, const Eigen::Vector3d& offset, const StraightWay& options);

}  // namespace symscene
