#include "symscene/motion/joint_space.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/random.hpp"
#include "symscene/core/error.hpp"

namespace symscene {

Eigen::VectorXd JointSpace::difference(const Eigen::VectorXd& from,
                                       const Eigen::VectorXd& to) const {
  Eigen::VectorXd way = to - from;
  for (Eigen::Index i = 0; i < way.size(); ++i) {
    if (continuous[static_cast<std::size_t>(i)])
      way[i] = std::remainder(way[i], 2.0 * std::numbers::pi);
  }
  return way;
}

Eigen::Index JointSpace::joint_outside(const Eigen::VectorXd& positions) const {
  constexpr double rounding = 1e-9;
  for (Eigen::Index i = 0; i < size(); ++i) {
    if (continuous[static_cast<std::size_t>(i)]) continue;
    if (!(positions[i] >= lower[i] - rounding && positions[i] <= upper[i] + rounding)) return i;
  }
  return -1;
}

Eigen::VectorXd JointSpace::sample(Random& random) const {
  Eigen::VectorXd positions(size());
  for (Eigen::Index i = 0; i < size(); ++i) {
    positions[i] = continuous[static_cast<std::size_t>(i)]
                       ? random.uniform(-std::numbers::pi, std::numbers::pi)
                       : random.uniform(lower[i], upper[i]);
  }
  return positions;
}

void JointSpace::validate() const {
  if (size() == 0) throw InputError("joint space", "at least one joint", "none");
  if (upper.size() != size() || continuous.size() != static_cast<std::size_t>(size()))
    throw InputError("joint space", "one limit of each kind per joint", "other numbers");
  for (Eigen::Index i = 0; i < size(); ++i) {
    if (continuous[static_cast<std::size_t>(i)]) continue;
    if (!std::isfinite(lower[i]) || !std::isfinite(upper[i]) || lower[i] > upper[i]) {
      throw InputError(fmt::format("limits of joint {}", i), "finite numbers in ascending order",
                       fmt::format("{} and {}", lower[i], upper[i]));
    }
  }
}

JointSpace joint_space(const RobotModel& model, const Arm& arm) {
  const auto joints = static_cast<Eigen::Index>(arm.positions.size());
  JointSpace space{Eigen::VectorXd(joints), Eigen::VectorXd(joints), {}};
  for (Eigen::Index i = 0; i < joints; ++i) {
    const std::size_t position = arm.positions[static_cast<std::size_t>(i)];
    const Joint& joint = model.joints[model.joint_of_position(position)];
    space.lower[i] = joint.limits.lower;
    space.upper[i] = joint.limits.upper;
    space.continuous.push_back(joint.kind == JointKind::continuous);
  }
  space.validate();
  return space;
}

}  // namespace symscene
