#pragma once

#include <vector>

#include "target.hpp"

namespace symscene {

/// A line along which the fingers may close on an object, from any direction across it.
struct ClosingLine {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< midway between the expected contacts [m]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitY();  ///< of the fingers' motion, unit vector
  double width = 0.0;                                    ///< between the expected contacts [m]
  GraspSource source = GraspSource::antipodal;
};

/// Lines through points of the surface along their normals.
std::vector<ClosingLine> antipodal_lines(const GraspTarget& target, const GraspOptions& options);

}  // namespace symscene
