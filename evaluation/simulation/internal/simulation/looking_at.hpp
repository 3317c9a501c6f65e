#pragma once

#include <Eigen/Geometry>

namespace symscene {

/// The pose of a camera at `eye` that looks at `target`, its image upright. z up.
Eigen::Isometry3d looking_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& target);

}  // namespace symscene
