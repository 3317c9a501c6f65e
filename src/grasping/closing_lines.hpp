#pragma once

#include <optional>
#include <vector>

#include "target.hpp"

namespace symscene {

/// A line along which the fingers may close on an object, from any direction across it.
struct ClosingLine {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< midway between the expected contacts [m]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitY();  ///< of the fingers' motion, unit vector
  double width = 0.0;                                    ///< between the expected contacts [m]
  GraspSource source = GraspSource::antipodal;
  /// Axis of a grasp of an axis: a grasp that approaches along it is one of its top.
  std::optional<Eigen::Vector3d> axis = {};
};

/// Lines across the axes of symmetry, at several heights and angles.
std::vector<ClosingLine> axis_lines(const GraspTarget& target,
                                    const GraspCandidateOptions& options);

/// Lines through the walls of open vessels near their rim, around an axis.
std::vector<ClosingLine> rim_lines(const GraspTarget& target, const GraspCandidateOptions& options);

/// Lines along the normals of mirror planes, near the centre of mass.
std::vector<ClosingLine> mirror_lines(const GraspTarget& target,
                                      const GraspCandidateOptions& options);

/// Lines between opposite faces of a box.
std::vector<ClosingLine> box_lines(const GraspTarget& target, const GraspCandidateOptions& options);

/// Lines through points of the surface along their normals.
std::vector<ClosingLine> antipodal_lines(const GraspTarget& target,
                                         const GraspCandidateOptions& options);

/// The line through `point` along `direction`, centred between the outermost samples near it; none
/// if there are none.
std::optional<ClosingLine> line_through(const GraspTarget& target, const Eigen::Vector3d& point,
                                        const Eigen::Vector3d& direction, GraspSource source);

}  // namespace symscene
