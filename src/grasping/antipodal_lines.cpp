#include <algorithm>
#include <cmath>
#include <limits>

#include "closing_lines.hpp"
#include "near_line.hpp"
#include "squared_distances.hpp"

namespace symscene {
namespace {

constexpr float ray_radius = 0.004F;    // somewhat more than the spacing of samples [m]
constexpr float least_width = 0.0015F;  // between opposite points [m]

/// `count` samples that are far apart: each is the farthest from those before it (Gonzalez 1985).
std::vector<Eigen::Index> spread_samples(const GraspTarget& target, std::size_t count) {
  const Points& points = target.samples.positions;
  std::vector<Eigen::Index> chosen;
  if (points.rows() == 0) return chosen;
  Eigen::ArrayXf distance = squared_distances(points, target.solid.centre_of_mass.cast<float>());
  Eigen::Index next = first_of(distance, distance.maxCoeff());
  distance.setConstant(std::numeric_limits<float>::infinity());
  while (chosen.size() < std::min(count, static_cast<std::size_t>(points.rows()))) {
    chosen.push_back(next);
    distance = distance.min(squared_distances(points, points.row(next).transpose()));
    next = first_of(distance, distance.maxCoeff());
  }
  return chosen;
}

/// Distances from a sample, against its normal, to the first and the last exit from the object.
struct Exits {
  float first = std::numeric_limits<float>::infinity();
  float last = 0.0F;
};

Exits exits_behind(const SurfaceSamples& samples, Eigen::Index start) {
  const Eigen::Vector3f origin = samples.positions.row(start).transpose();
  const Eigen::Vector3f inwards = -samples.normals.row(start).transpose();
  Exits exits;
  for_each_near_line(samples, origin, inwards, ray_radius, [&](Eigen::Index i, float along) {
    if (along < least_width || samples.normals.row(i).dot(inwards) < 0.5F) return;
    exits.first = std::min(exits.first, along);
    exits.last = std::max(exits.last, along);
  });
  return exits;
}

/// The directions in which fingers may close at a normal: level, which is the only one for low
/// objects as both tips must clear the table, and along the normal unless that is nearly level.
std::vector<Eigen::Vector3d> closing_directions(const Eigen::Vector3d& normal,
                                                const Eigen::Vector3d& up) {
  constexpr double nearly_level = radians(10.0);
  constexpr double steepest_to_level = radians(30.0);
  const double elevation = std::asin(std::clamp(std::abs(normal.dot(up)), 0.0, 1.0));
  std::vector<Eigen::Vector3d> directions;
  if (elevation < steepest_to_level)
    directions.emplace_back((normal - normal.dot(up) * up).normalized());
  if (elevation > nearly_level) directions.push_back(normal);
  return directions;
}

}  // namespace

std::vector<ClosingLine> antipodal_lines(const GraspTarget& target,
                                         const GraspCandidateOptions& options) {
  std::vector<ClosingLine> lines;
  const auto count = static_cast<std::size_t>(options.surface_points);
  for (const Eigen::Index start : spread_samples(target, count)) {
    const Exits exits = exits_behind(target.samples, start);
    if (exits.last <= 0.0F) continue;
    const Eigen::Vector3d point = target.samples.positions.row(start).transpose().cast<double>();
    const Eigen::Vector3d normal = target.samples.normals.row(start).transpose().cast<double>();
    const auto add = [&](double width) {
      for (const Eigen::Vector3d& direction : closing_directions(normal, target.up))
        lines.push_back({point - width / 2.0 * normal, direction, width});
    };
    add(exits.first);
    if (exits.last > exits.first + 3.0F * ray_radius) add(exits.last);
  }
  return lines;
}

}  // namespace symscene
