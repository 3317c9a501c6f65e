#pragma once

#include <cmath>

#include "core/twist.hpp"
#include "symscene/robots/arm_chain.hpp"

namespace symscene {

constexpr int max_arm_joints = 16;
/// Positions and Jacobians of a chain, without allocation.
using ChainVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, max_arm_joints, 1>;
using ChainJacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, max_arm_joints>;

/// The tip's pose at these positions. visit(i, axis, origin) gets the axis of joint i and a point
/// on it, in the base link.
template <class Visit>
Eigen::Isometry3d follow_chain(const ArmChain& chain, const ChainVector& q, const Visit& visit) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const ChainJoint& joint = chain.joints[i];
    const auto at = static_cast<Eigen::Index>(i);
    t += R * joint.T_previous_joint.translation();
    R = (R * joint.T_previous_joint.linear()).eval();
    visit(at, Eigen::Vector3d(R.col(2)), t);
    if (joint.kind == JointKind::prismatic) {
      t += q[at] * R.col(2);
      continue;
    }
    const double c = std::cos(q[at]), s = std::sin(q[at]);
    const Eigen::Vector3d x = R.col(0);
    R.col(0) = c * x + s * R.col(1);
    R.col(1) = c * R.col(1) - s * x;
  }
  Eigen::Isometry3d T_base_tip = Eigen::Isometry3d::Identity();
  T_base_tip.translation() = t + R * chain.T_last_tip.translation();
  T_base_tip.linear() = R * chain.T_last_tip.linear();
  return T_base_tip;
}

/// The tip's pose, and its geometric Jacobian (angular rows first).
inline Eigen::Isometry3d tip_and_jacobian(const ArmChain& chain, const ChainVector& q,
                                          ChainJacobian& J) {
  J.resize(6, static_cast<Eigen::Index>(chain.joints.size()));
  // Columns hold the axis and a point on it until the tip is known.
  const Eigen::Isometry3d T_base_tip =
      follow_chain(chain, q, [&](Eigen::Index i, const auto& axis, const auto& origin) {
        J.col(i).head<3>() = axis;
        J.col(i).tail<3>() = origin;
      });
  for (Eigen::Index i = 0; i < J.cols(); ++i) {
    const Eigen::Vector3d axis = J.col(i).head<3>(), origin = J.col(i).tail<3>();
    if (chain.joints[static_cast<std::size_t>(i)].kind == JointKind::prismatic)
      J.col(i) << Eigen::Vector3d::Zero(), axis;
    else
      J.col(i).tail<3>() = axis.cross(T_base_tip.translation() - origin);
  }
  return T_base_tip;
}

}  // namespace symscene
