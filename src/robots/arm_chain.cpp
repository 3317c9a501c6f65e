#include "symscene/robots/arm_chain.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "chain_arithmetic.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/geometry.hpp"

namespace symscene {
namespace {

ChainVector checked(const ArmChain& chain, const Eigen::VectorXd& positions) {
  if (positions.size() != static_cast<Eigen::Index>(chain.joints.size()) || !positions.allFinite())
    throw InputError("arm", fmt::format("{} finite joint positions", chain.joints.size()),
                     fmt::format("{} numbers", positions.size()));
  return positions;
}

void require_limits(const RobotModel& model, const Joint& joint) {
  if (std::isfinite(joint.limits.lower) && std::isfinite(joint.limits.upper)) return;
  throw InputError(fmt::format("robot {}, joint {}", model.name, joint.name),
                   "limits of its position", "none");
}

}  // namespace

ArmChain arm_chain(const RobotModel& model, const Arm& arm) {
  if (arm.positions.size() > static_cast<std::size_t>(max_arm_joints))
    throw InputError(fmt::format("robot {}, arm {}", model.name, arm.name),
                     fmt::format("at most {} moving joints", max_arm_joints),
                     fmt::format("{}", arm.positions.size()));
  ArmChain chain;
  for (const std::size_t index : arm.joints) {
    const Joint& joint = model.joints[index];
    chain.T_last_tip = chain.T_last_tip * joint.T_parent_joint;
    if (!joint.position) continue;
    require_limits(model, joint);
    // Turned so that the axis is z, which makes a step along the chain cheap.
    const Eigen::Isometry3d z_to_axis(shortest_rotation(Eigen::Vector3d::UnitZ(), joint.axis));
    chain.joints.push_back(
        {chain.T_last_tip * z_to_axis, joint.kind, joint.limits.lower, joint.limits.upper});
    chain.T_last_tip = z_to_axis.inverse();
  }
  return chain;
}

double ArmChain::length() const {
  double sum = T_last_tip.translation().norm();
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (i > 0) sum += joints[i].T_previous_joint.translation().norm();
    if (joints[i].kind == JointKind::prismatic)
      sum += std::max(std::abs(joints[i].lower), std::abs(joints[i].upper));
  }
  return sum;
}

double ArmChain::distance_to(const Eigen::Vector3d& point_base) const {
  if (joints.empty()) return point_base.norm();
  return (point_base - joints.front().T_previous_joint.translation()).norm();
}

Eigen::Isometry3d tip_pose(const ArmChain& chain, const Eigen::VectorXd& positions) {
  return follow_chain(chain, checked(chain, positions), [](auto&&...) {});
}

Eigen::Matrix<double, 6, Eigen::Dynamic> tip_jacobian(const ArmChain& chain,
                                                      const Eigen::VectorXd& positions) {
  ChainJacobian J;
  tip_and_jacobian(chain, checked(chain, positions), J);
  return J;
}

}  // namespace symscene
