#include <cmath>
#include <limits>
#include <numbers>

#include "closing_lines.hpp"
#include "tool_pose.hpp"

namespace symscene {
namespace {

/// The wall at a rim, near one angle about the axis.
struct Wall {
  double inner = std::numeric_limits<double>::infinity();  ///< least radius of the inside [m]
  double outer = 0.0;                                      ///< greatest radius of the outside [m]
  /// Sum of the outside's normals and the negative ones of the inside.
  Eigen::Vector3d normals = Eigen::Vector3d::Zero();

  double width() const { return outer - inner; }
};

/// A vessel's axis, pointing out of its opening, and the highest point along it.
struct Rim {
  Eigen::Vector3d axis;
  Eigen::Vector3d point;  ///< of the axis, at the height of the rim
};

Rim rim_of(const GraspTarget& target, const RotationAxis& axis) {
  const Eigen::Vector3d up =
      axis.direction.dot(target.up) < 0.0 ? Eigen::Vector3d(-axis.direction) : axis.direction;
  const Points& points = target.samples.positions;
  const Eigen::RowVector3f base = axis.point.cast<float>().transpose();
  const double top = ((points.rowwise() - base) * up.cast<float>()).maxCoeff();
  return {up, axis.point + top * up};
}

Wall wall_towards(const SurfaceSamples& samples, const Rim& rim, const Eigen::Vector3d& radial,
                  const GraspCandidateOptions& options) {
  Wall wall;
  const Eigen::Vector3d across = rim.axis.cross(radial);
  for (Eigen::Index i = 0; i < samples.size(); ++i) {
    const Eigen::Vector3d p = samples.positions.row(i).transpose().cast<double>() - rim.point;
    const double radius = p.dot(radial);
    const double below = -p.dot(rim.axis);
    if (radius <= 0.0 || below > options.rim_depth || std::abs(p.dot(across)) > options.rim_window)
      continue;
    const Eigen::Vector3d normal = samples.normals.row(i).transpose().cast<double>();
    const double facing = normal.dot(radial);
    if (std::abs(facing) < 0.5) continue;
    if (facing < 0.0) wall.inner = std::min(wall.inner, radius);
    if (facing > 0.0) wall.outer = std::max(wall.outer, radius);
    wall.normals += std::copysign(1.0, facing) * (normal - normal.dot(across) * across);
  }
  return wall;
}

}  // namespace

std::vector<ClosingLine> rim_lines(const GraspTarget& target,
                                   const GraspCandidateOptions& options) {
  std::vector<ClosingLine> lines;
  for (const ObjectAxis& found : target.description.axes) {
    const Rim rim = rim_of(target, found.axis);
    const Eigen::Vector3d start = direction_across(rim.axis, {target.seen_from});
    for (int k = 0; k < 2 * options.axis_angles; ++k) {
      const double angle = std::numbers::pi * k / options.axis_angles;
      const Eigen::Vector3d radial = Eigen::AngleAxisd(angle, rim.axis) * start;
      const Wall wall = wall_towards(target.samples, rim, radial, options);
      if (!(wall.width() > 0.0) || wall.width() > options.max_wall) continue;
      lines.push_back({rim.point - options.rim_depth / 2.0 * rim.axis +
                           0.5 * (wall.inner + wall.outer) * radial,
                       wall.normals.normalized(), wall.width(), GraspSource::rim});
    }
  }
  return lines;
}

}  // namespace symscene
