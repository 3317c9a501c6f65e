#include "straight_way.hpp"

#include <cmath>

namespace symscene {

std::optional<std::vector<Eigen::VectorXd>> straight_way(const ArmChain& chain,
                                                         const JointSpace& space,
                                                         const Eigen::VectorXd& start,
                                                         const Eigen::Isometry3d& T_base_tip,
                                                         const Eigen::Vector3d& offset,
                                                         const StraightWay& options) {
  InverseKinematicsOptions near;
  near.max_starts = 1;  // the positions before are the only start: others would be jumps
  std::vector<Eigen::VectorXd> way{start};
  const double steps = std::max(1.0, std::ceil(offset.norm() / options.step));
  for (double i = 1.0; i <= steps; i += 1.0) {
    Eigen::Isometry3d pose = T_base_tip;
    pose.translation() += i / steps * offset;
    const InverseKinematicsResult next = inverse_kinematics(chain, pose, way.back(), near);
    if (!next.converged()) return std::nullopt;
    const Eigen::VectorXd change = space.difference(way.back(), next.positions);
    if (change.cwiseAbs().maxCoeff() > options.max_jump) return std::nullopt;
    way.emplace_back(way.back() + change);
  }
  return way;
}

}  // namespace symscene
