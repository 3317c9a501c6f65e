#pragma once

#include <functional>
#include <vector>

#include "symscene/motion/joint_space.hpp"

namespace symscene {

class Random;

using MotionCheck = std::function<bool(const Eigen::VectorXd&, const Eigen::VectorXd&)>;

/// A path with the same ends that is not longer: straight lines join random points of it where
/// they are free (Geraerts and Overmars 2007), and waypoints that the path does not need go.
std::vector<Eigen::VectorXd> shortened(std::vector<Eigen::VectorXd> path,
                                       const MotionCheck& is_free, int tries, Random& random);

}  // namespace symscene
