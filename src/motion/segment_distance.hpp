#pragma once

#include "symscene/robots/robot_model.hpp"

namespace symscene {

/// The distance of a point from the segment between two others. [m]
double segment_distance(const Eigen::Vector3d& point, const Eigen::Vector3d& begin,
                        const Eigen::Vector3d& end);

/// The distance between the surfaces of two capsules; negative where they overlap. [m]
double capsule_distance(const Capsule& a, const Capsule& b);

/// The capsule in another frame.
Capsule transformed(const Capsule& capsule, const Eigen::Isometry3d& T);

}  // namespace symscene
