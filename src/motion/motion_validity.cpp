#include "symscene/motion/motion_validity.hpp"

namespace symscene {

MotionValidity motion_validity(const ArmCollision& arm, const IgnoredObstacles& ignored) {
  return {[&arm, ignored](const Eigen::VectorXd& q) {
            const auto met = arm.contact(q, ignored);
            return met ? describe(*met) : std::string();
          },
          [&arm, ignored](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
            return arm.is_free(a, b, ignored);
          }};
}

}  // namespace symscene
