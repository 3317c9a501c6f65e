#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "symscene/core/options.hpp"
#include "symscene/robots/arm_chain.hpp"

namespace symscene {

struct InverseKinematicsOptions {
  int max_starts = 64;
  int max_iterations = 60;
  double position_tolerance = 1e-6;
  double rotation_tolerance = 1e-6;
  double max_step = 0.7;
  double damping = 0.05;
  int refinements = 12;
  double distinct = 0.2;
  bool limits = true;
  std::uint64_t seed = 0;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("max_starts", self.max_starts, "", between(1, 1e6),
          "joint vectors from which the search starts: the reference, then random ones");
    visit("max_iterations", self.max_iterations, "", between(1, 1e6),
          "greatest number of steps from each start");
    visit("position_tolerance", self.position_tolerance, "m", above_up_to(0.0, 1.0),
          "error of the tip's position at which the pose counts as reached");
    visit("rotation_tolerance", self.rotation_tolerance, "rad", above_up_to(0.0, 1.0),
          "error of the tip's orientation at which the pose counts as reached");
    visit("max_step", self.max_step, "rad", above_up_to(0.0, 10.0),
          "greatest change of a joint in one step; metres for a sliding joint");
    visit("damping", self.damping, "", above_up_to(0.0, 1e3),
          "damping of the normal equations per squared error (Sugihara 2011)");
    visit("refinements", self.refinements, "", between(0, 1e4),
          "steps in the null space of the Jacobian towards the reference");
    visit("distinct", self.distinct, "rad", above_up_to(0.0, 10.0),
          "least difference of some joint between two solutions of one pose");
    visit("limits", self.limits, "", any_value(),
          "keep turning joints within their limits; sliding joints always are");
    visit("seed", self.seed, "", any_value(), "seed of the random starts");
  }
  void validate() const { check_fields(*this); }
};

enum class InverseKinematicsStatus : std::uint8_t {
  converged,
  not_reached  ///< no start led to the pose
};

/// Joint positions of an arm for a pose of its tip.
struct InverseKinematicsResult {
  InverseKinematicsStatus status = InverseKinematicsStatus::not_reached;
  Eigen::VectorXd positions;    ///< of the arm's joints; those of least error if not reached
  double position_error = 0.0;  ///< that remains [m]
  double rotation_error = 0.0;  ///< that remains [rad]
  int starts = 0;               ///< used
  int iterations = 0;           ///< over all starts

  bool converged() const { return status == InverseKinematicsStatus::converged; }
};

/// The middle of the joints' ranges: the reference that keeps solutions far from the limits.
Eigen::VectorXd middle_of_limits(const ArmChain& chain);

/// Joint positions that bring the tip to T_base_tip (in the arm's base link): damped least squares
/// with joint limits from several starts (Sugihara 2011). With more joints than the pose needs, the
/// solution is moved in the Jacobian's null space towards `reference`: the sum of squared
/// differences, relative to the joints' ranges, descends. Throws InputError if the pose is not
/// finite or the reference has another size.
InverseKinematicsResult inverse_kinematics(const ArmChain& chain,
                                           const Eigen::Isometry3d& T_base_tip,
                                           const Eigen::VectorXd& reference,
                                           const InverseKinematicsOptions& options = {});
/// The same with the middle of the limits as the reference.
InverseKinematicsResult inverse_kinematics(const ArmChain& chain,
                                           const Eigen::Isometry3d& T_base_tip,
                                           const InverseKinematicsOptions& options = {});

/// Up to `count` distinct solutions, the nearest to the reference first. They are not moved in the
/// null space, so that they sample the redundancy of the arm. Empty if the pose is not reached.
std::vector<Eigen::VectorXd> inverse_kinematics_solutions(
    const ArmChain& chain, const Eigen::Isometry3d& T_base_tip, const Eigen::VectorXd& reference,
    std::size_t count, const InverseKinematicsOptions& options = {});

/// Joint positions that bring the tip's origin to a point, with any orientation.
InverseKinematicsResult inverse_kinematics_of_point(const ArmChain& chain,
                                                    const Eigen::Vector3d& point_base,
                                                    const Eigen::VectorXd& reference,
                                                    const InverseKinematicsOptions& options = {});

}  // namespace symscene
