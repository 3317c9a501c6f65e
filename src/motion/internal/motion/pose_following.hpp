#pragma once

#include <optional>
#include <span>
#include <vector>

#include "symscene/motion/joint_space.hpp"
#include "symscene/robots/inverse_kinematics.hpp"

namespace symscene {

/// Joint positions at which the tip takes poses in the base link's frame one after the other, after
/// those of `start`. None if a joint has to jump by more than `max_jump` [rad] from one to the
/// next, or to leave its limits.
std::optional<std::vector<Eigen::VectorXd>> followed_poses(const ArmChain& chain,
                                                           const JointSpace& space,
                                                           const Eigen::VectorXd& start,
                                                           std::span<const Eigen::Isometry3d> poses,
                                                           double max_jump);

}  // namespace symscene
