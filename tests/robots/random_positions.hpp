#pragma once

#include "core/random.hpp"
#include "symscene/robots/arm_chain.hpp"

namespace symscene {

/// Uniform within the limits.
inline Eigen::VectorXd random_positions(const ArmChain& chain, Random& random) {
  Eigen::VectorXd q(static_cast<Eigen::Index>(chain.joints.size()));
  for (std::size_t i = 0; i < chain.joints.size(); ++i)
    q[static_cast<Eigen::Index>(i)] = random.uniform(chain.joints[i].lower, chain.joints[i].upper);
  return q;
}

}  // namespace symscene
