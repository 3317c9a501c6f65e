#include "straight_way.hpp"

#include <algorithm>
#include <cmath>

#include "motion/pose_following.hpp"

namespace symscene {

std::optional<std::vector<Eigen::VectorXd>> straight_way(const ArmChain& chain,
                                                         const JointSpace& space,
                                                         const Eigen::VectorXd& start,
                                                         const Eigen::Isometry3d& T_base_tip,
                                                         const Eigen::Vector3d& offset,
                                                         const StraightWay& options) {
  std::vector<Eigen::Isometry3d> poses;
  const double steps = std::max(1.0, std::ceil(offset.norm() / options.step));
  for (double i = 1.0; i <= steps; i += 1.0) {
    poses.push_back(T_base_tip);
    poses.back().translation() += i / steps * offset;
  }
  return followed_poses(chain, space, start, poses, options.max_jump);
}

}  // namespace symscene
