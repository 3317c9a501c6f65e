#include "motion/pose_following.hpp"

namespace symscene {

std::optional<std::vector<Eigen::VectorXd>> followed_poses(const ArmChain& chain,
                                                           const JointSpace& space,
                                                           const Eigen::VectorXd& start,
                                                           std::span<const Eigen::Isometry3d> poses,
                                                           double max_jump) {
  InverseKinematicsOptions near;
  near.max_starts = 1;  // the positions before are the only start: others would be jumps
  std::vector<Eigen::VectorXd> way{start};
  for (const Eigen::Isometry3d& pose : poses) {
    const InverseKinematicsResult next = inverse_kinematics(chain, pose, way.back(), near);
    if (!next.converged()) return std::nullopt;
    const Eigen::VectorXd change = space.difference(way.back(), next.positions);
    if (change.cwiseAbs().maxCoeff() > max_jump) return std::nullopt;
    way.emplace_back(way.back() + change);
  }
  return way;
}

}  // namespace symscene
