#pragma once

#include "chain_arithmetic.hpp"
#include "symscene/robots/inverse_kinematics.hpp"

namespace symscene {

/// Searches joint positions for one pose of a chain's tip, by damped least squares.
class PoseSolver {
 public:
  /// Without `orientation` the tip may have any.
  PoseSolver(const ArmChain& chain, const Eigen::Isometry3d& T_base_tip, bool orientation,
             const InverseKinematicsOptions& options);

  /// Moves q towards the pose until it is reached or the error no longer decreases.
  bool solve(ChainVector& q);
  /// Moves a solution in the null space of the Jacobian towards the reference.
  void refine(ChainVector& q, const ChainVector& reference);

  /// The positions in the joints' limits; turning joints by whole turns where that helps.
  ChainVector within_limits(ChainVector q) const;
  /// Differences relative to the joints' ranges, root of the sum of squares.
  double distance(const ChainVector& a, const ChainVector& b) const;

  double position_error(const ChainVector& q) const;
  double rotation_error(const ChainVector& q) const;
  int iterations() const { return iterations_; }
  const ChainVector& lower() const { return lower_; }
  const ChainVector& upper() const { return upper_; }

 private:
  void evaluate(const ChainVector& q);
  bool reached() const;
  /// The bounded step that reduces the error, plus `drift` in the null space.
  ChainVector step(const ChainVector& q, const ChainVector& drift) const;

  const ArmChain& chain_;
  Eigen::Isometry3d T_base_tip_;
  InverseKinematicsOptions options_;
  bool orientation_;
  double per_metre_ = 1.0;
  ChainVector lower_, upper_, range_;
  ChainJacobian J_;
  Vector6d error_ = Vector6d::Zero();
  int iterations_ = 0;
};

}  // namespace symscene
