#pragma once

#include <vector>

#include "symscene/robots/robot_model.hpp"

namespace symscene {

class Random;

/// The configurations of an arm: one number per moving joint, in order. Positions of continuous
/// joints that differ by full turns are one configuration. [rad or m]
struct JointSpace {
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;
  std::vector<bool> continuous;  ///< without limits

  Eigen::Index size() const { return lower.size(); }
  /// The shortest way from one configuration to another: add it to the first.
  Eigen::VectorXd difference(const Eigen::VectorXd& from, const Eigen::VectorXd& to) const;
  /// Index of the first joint outside its limits, by more than rounding; −1 for none.
  Eigen::Index joint_outside(const Eigen::VectorXd& positions) const;
  /// Evenly distributed; continuous joints in [−π, π).
  Eigen::VectorXd sample(Random& random) const;
  /// Throws InputError if sizes differ, there is no joint, or a limit is not finite or in order.
  void validate() const;
};

/// The space of an arm's moving joints.
JointSpace joint_space(const RobotModel& model, const Arm& arm);

}  // namespace symscene
