#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "closing_lines.hpp"
#include "near_line.hpp"
#include "tool_pose.hpp"

namespace symscene {
namespace {

constexpr float line_radius = 0.006F;  // about a line, twice the spacing of samples [m]

/// Least and greatest value. [m]
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double length() const { return high - low; }
  double middle() const { return 0.5 * (low + high); }
};

Extent extent_along(const SurfaceSamples& samples, const Eigen::Vector3d& point,
                    const Eigen::Vector3d& direction) {
  const Eigen::VectorXf along =
      (samples.positions.rowwise() - point.cast<float>().transpose()) * direction.cast<float>();
  return {along.minCoeff(), along.maxCoeff()};
}

/// Positions in an extent, evenly spread, about `spacing` apart, symmetric about its middle.
std::vector<double> positions_in(const Extent& extent, double spacing) {
  const int count = std::max(1, static_cast<int>(std::ceil(extent.length() / spacing)));
  std::vector<double> positions;
  for (int i = 0; i < count; ++i)
    positions.push_back(extent.low + (i + 0.5) * extent.length() / count);
  return positions;
}

/// A direction across `direction` that moves with the scene: towards the camera, or else level.
Eigen::Vector3d reference_across(const GraspTarget& target, const Eigen::Vector3d& direction) {
  return direction_across(direction, {target.seen_from, target.up.cross(direction)});
}

/// Lines along `normal` through a grid of points in the plane across it.
std::vector<ClosingLine> lines_across(const GraspTarget& target, const Eigen::Vector3d& point,
                                      const Eigen::Vector3d& normal, GraspSource source,
                                      const GraspCandidateOptions& options) {
  const Eigen::Vector3d u = reference_across(target, normal);
  const Eigen::Vector3d v = normal.cross(u);
  const Eigen::Vector3d& mass = target.solid.centre_of_mass;
  const Eigen::Vector3d origin = mass - (mass - point).dot(normal) * normal;
  std::vector<ClosingLine> lines;
  for (const double a :
       positions_in(extent_along(target.samples, origin, u), options.line_spacing)) {
    for (const double b :
         positions_in(extent_along(target.samples, origin, v), options.line_spacing)) {
      if (std::hypot(a, b) > options.max_lever_arm) continue;
      if (const auto line = line_through(target, origin + a * u + b * v, normal, source))
        lines.push_back(*line);
    }
  }
  if (const auto line = line_through(target, origin, normal, source)) lines.push_back(*line);
  return lines;
}

void append(std::vector<ClosingLine>& lines, const std::vector<ClosingLine>& more) {
  lines.insert(lines.end(), more.begin(), more.end());
}

}  // namespace

std::optional<ClosingLine> line_through(const GraspTarget& target, const Eigen::Vector3d& point,
                                        const Eigen::Vector3d& direction, GraspSource source) {
  Extent extent;
  for_each_near_line(target.samples, point.cast<float>(), direction.cast<float>(), line_radius,
                     [&](Eigen::Index, float distance) { extent.add(distance); });
  if (!(extent.length() > 0.0)) return std::nullopt;
  return ClosingLine{point + extent.middle() * direction, direction, extent.length(), source};
}

std::vector<ClosingLine> axis_lines(const GraspTarget& target,
                                    const GraspCandidateOptions& options) {
  std::vector<ClosingLine> lines;
  for (const ObjectAxis& found : target.description.axes) {
    const Eigen::Vector3d& axis = found.axis.direction;
    const Eigen::Vector3d base = found.axis.project(target.solid.centre_of_mass);
    const Eigen::Vector3d reference = reference_across(target, axis);
    const Extent extent = extent_along(target.samples, base, axis);
    for (const double height : positions_in(extent, options.line_spacing)) {
      for (int k = 0; k < options.axis_angles; ++k) {
        const double angle = std::numbers::pi * k / options.axis_angles;
        auto line =
            line_through(target, base + height * axis, Eigen::AngleAxisd(angle, axis) * reference,
                         GraspSource::axis_side);
        if (!line) continue;
        line->axis = axis;
        lines.push_back(*line);
      }
    }
  }
  return lines;
}

std::vector<ClosingLine> mirror_lines(const GraspTarget& target,
                                      const GraspCandidateOptions& options) {
  std::vector<ClosingLine> lines;
  for (const ObjectPlane& found : target.description.planes) {
    append(lines, lines_across(target, found.plane.point, found.plane.normal,
                               GraspSource::mirror_plane, options));
  }
  return lines;
}

std::vector<ClosingLine> box_lines(const GraspTarget& target,
                                   const GraspCandidateOptions& options) {
  std::vector<ClosingLine> lines;
  const std::optional<ObjectClass>& found = target.description.symmetry_class;
  if (!found || found->kind != SymmetryClass::box) return lines;
  for (int k = 0; k < 3; ++k) {
    append(lines,
           lines_across(target, found->center, found->axes.col(k), GraspSource::box_face, options));
  }
  return lines;
}

}  // namespace symscene
