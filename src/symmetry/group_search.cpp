#include "group_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "core/parallel.hpp"
#include "core/without_repeats.hpp"

namespace symscene {
namespace {

/// The turns of an axis up to a half, as those beyond are their inverses.
std::vector<double> angles_of(int order) {
  // Multiples of no turn of a low order.
  constexpr int parts = 15;
  const int n = order == GroupAxis::continuous ? parts : order;
  std::vector<double> angles;
  for (int k = 1; 2 * k <= n; ++k) angles.push_back(2.0 * std::numbers::pi * k / n);
  return angles;
}

/// The least divisor above one.
int least_divisor(int number) {
  int divisor = 2;
  while (number % divisor != 0) ++divisor;
  return divisor;
}

constexpr double flat = 0.97;

/// Whether a residual does not fall when the direction is tilted to any side by an angle. The fit
/// minimises robust point-to-plane residuals, so that the mean distance may be a little less beside
/// a flat minimum.
template <class Residual>
bool is_minimum(const Eigen::Vector3d& direction, double residual, double tilt,
                const Residual& residual_of) {
  const Eigen::Matrix<double, 3, 2> basis = orthonormal_complement(direction);
  for (int k = 0; k < 8; ++k) {
    const double turn = k * std::numbers::pi / 4.0;
    const Eigen::Vector3d side = basis * Eigen::Vector2d(std::cos(turn), std::sin(turn));
    if (residual_of((direction + std::tan(tilt) * side).normalized()) < flat * residual)
      return false;
  }
  return true;
}

constexpr double never = std::numeric_limits<double>::infinity();

/// Fitted to the surface; with an infinite residual if it is far from a symmetry.
GroupPlane fitted_plane(const SymmetryModel& model, const ReflectionPlane& start,
                        const SymmetryGroupOptions& options) {
  ReflectionPlane plane = fit_to(model.surface, model.coarse, start, Matching::coarse);
  if (mean_distance(model.surface, model.coarse, motion_of(plane), Matching::coarse) >
      options.tolerance + options.step_distance)
    return {plane, never};
  plane = fit_to(model.surface, model.fitted, plane, Matching::exact);
  const double residual = model.residual(plane);
  const bool holds = residual <= options.tolerance && !model.moves_part(motion_of(plane), options);
  return {plane, holds ? residual : never};
}

GroupAxis fitted_axis(const SymmetryModel& model, const RotationAxis& start, int order,
                      const SymmetryGroupOptions& options) {
  const std::vector<double> angles = angles_of(order);
  RotationAxis axis = fit_to(model.surface, model.coarse, start, angles, Matching::coarse);
  if (mean_distance(model.surface, model.coarse, axis, angles, Matching::coarse) >
      options.tolerance + options.step_distance)
    return {axis, order, never};
  axis = fit_to(model.surface, model.fitted, axis, angles, Matching::exact);
  const double residual = model.residual(axis, angles);
  // Half turns of a slender shape are also products of its planes, which have no such bound.
  const double bound =
      order == 2 ? options.tolerance
                 : std::min(options.tolerance, options.radius_share * model.mean_radius(axis));
  const bool holds =
      residual <= bound && std::none_of(angles.begin(), angles.end(), [&](double angle) {
        return model.moves_part(motion_of(axis, angle), options);
      });
  return {axis, order, holds ? residual : never};
}

const Eigen::Vector3d& direction_of(const GroupPlane& found) { return found.plane.normal; }
const Eigen::Vector3d& direction_of(const GroupAxis& found) { return found.axis.direction; }

/// Those within the tolerance, best first, without those near a better one.
template <class Symmetry>
std::vector<Symmetry> distinct(std::vector<Symmetry> found, const SymmetryGroupOptions& options) {
  std::stable_sort(found.begin(), found.end(),
                   [](const Symmetry& a, const Symmetry& b) { return a.residual < b.residual; });
  std::erase_if(found, [&](const Symmetry& each) { return !(each.residual <= options.tolerance); });
  return without_repeats(std::move(found), [&](const Symmetry& a, const Symmetry& b) {
    return line_angle(direction_of(a), direction_of(b)) < options.same_angle;
  });
}

}  // namespace

std::vector<Eigen::Vector3d> hemisphere(int count) {
  std::vector<Eigen::Vector3d> directions;
  for (int k = 0; k < count; ++k) {
    const double z = (k + 0.5) / count;
    const double azimuth = std::numbers::pi * (3.0 - std::sqrt(5.0)) * k;
    const double radius = std::sqrt(1.0 - z * z);
    directions.emplace_back(radius * std::cos(azimuth), radius * std::sin(azimuth), z);
  }
  return directions;
}

template <class Distance>
std::vector<Eigen::Vector3d> GroupSearch::candidates(const Distance& distance_of) const {
  constexpr std::size_t block = 64;
  std::vector<double> distances(directions_.size());
  parallel_for_blocks(distances.size(), block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) distances[k] = distance_of(directions_[k]);
  });
  std::vector<std::size_t> minima;
  for (std::size_t k = 0; k < distances.size(); ++k) {
    if (distances[k] <= options_.tolerance + options_.step_distance &&
        is_least_around(k, distances))
      minima.push_back(k);
  }
  std::stable_sort(minima.begin(), minima.end(),
                   [&](std::size_t a, std::size_t b) { return distances[a] < distances[b]; });
  minima.resize(std::min(minima.size(), static_cast<std::size_t>(options_.max_candidates)));
  std::vector<Eigen::Vector3d> best;
  for (const std::size_t k : minima) best.push_back(directions_[k]);
  return best;
}

bool GroupSearch::is_least_around(std::size_t k, const std::vector<double>& distances) const {
  const double cosine = std::cos(options_.candidate_angle);
  for (std::size_t other = 0; other < distances.size(); ++other) {
    if (distances[other] < distances[k] &&
        std::abs(directions_[other].dot(directions_[k])) > cosine)
      return false;
  }
  return true;
}

std::vector<GroupPlane> GroupSearch::planes() const {
  const std::vector<Eigen::Vector3d> normals = candidates([&](const Eigen::Vector3d& normal) {
    return mean_distance(model_.surface, model_.coarse,
                         motion_of(ReflectionPlane{Eigen::Vector3d::Zero(), normal}),
                         Matching::coarse);
  });
  std::vector<GroupPlane> found(normals.size());
  parallel_for_each(normals.size(), [&](std::size_t k) {
    found[k] = fitted_plane(model_, {Eigen::Vector3d::Zero(), normals[k]}, options_);
  });
  found = distinct(std::move(found), options_);
  std::erase_if(found, [&](const GroupPlane& plane) {
    return !is_minimum(plane.plane.normal, plane.residual, options_.tilt_angle,
                       [&](const Eigen::Vector3d& normal) {
                         return model_.residual(ReflectionPlane{plane.plane.point, normal});
                       });
  });
  return found;
}

std::vector<GroupAxis> GroupSearch::axes(int order) const {
  const std::vector<double> angles = angles_of(order);
  // The first angle makes all turns of an order; two suffice for a continuous axis.
  const std::span tried(angles.data(), order == GroupAxis::continuous ? 2 : 1);
  const std::vector<Eigen::Vector3d> starts = candidates([&](const Eigen::Vector3d& direction) {
    return mean_distance(model_.surface, model_.coarse, {Eigen::Vector3d::Zero(), direction}, tried,
                         Matching::coarse);
  });
  std::vector<GroupAxis> found(starts.size());
  parallel_for_each(starts.size(), [&](std::size_t k) {
    found[k] = fitted_axis(model_, {Eigen::Vector3d::Zero(), starts[k]}, order, options_);
  });
  found = distinct(std::move(found), options_);
  std::erase_if(found, [&](const GroupAxis& axis) {
    return !is_minimum(axis.axis.direction, axis.residual, options_.tilt_angle,
                       [&](const Eigen::Vector3d& direction) {
                         return model_.residual(RotationAxis{axis.axis.point, direction}, angles);
                       });
  });
  return found;
}

std::vector<GroupAxis> GroupSearch::multiples(const GroupAxis& axis) const {
  std::vector<int> orders;
  for (int order = 2 * axis.order; order <= options_.max_order; order += axis.order) {
    if (least_divisor(order) == axis.order) orders.push_back(order);
  }
  std::vector<GroupAxis> found(orders.size());
  parallel_for_each(orders.size(), [&](std::size_t k) {
    found[k] = fitted_axis(model_, axis.axis, orders[k], options_);
  });
  std::erase_if(found, [&](const GroupAxis& each) { return each.residual == never; });
  return found;
}

std::vector<GroupAxis> GroupSearch::finite_axes() const {
  std::vector<GroupAxis> all;
  // An axis of any order is one of the primes that divide it.
  for (int order = 2; order <= options_.max_order; ++order) {
    if (least_divisor(order) != order) continue;
    for (const GroupAxis& found : axes(order)) {
      all.push_back(found);
      const std::vector<GroupAxis> higher = multiples(found);
      all.insert(all.end(), higher.begin(), higher.end());
    }
  }
  std::vector<GroupAxis> kept;
  for (const GroupAxis& best : distinct(all, options_)) {
    // Turns that are within the tolerance only because they are small do not count.
    const double bound = std::max(options_.order_ratio * best.residual, options_.tolerance / 3.0);
    GroupAxis highest = best;
    for (const GroupAxis& other : all) {
      if (line_angle(other.axis.direction, best.axis.direction) < options_.same_angle &&
          other.residual <= bound && other.order > highest.order)
        highest = other;
    }
    kept.push_back(highest);
  }
  std::stable_sort(kept.begin(), kept.end(),
                   [](const GroupAxis& a, const GroupAxis& b) { return a.order > b.order; });
  return kept;
}

void GroupSearch::complete(const GroupAxis& axis, SymmetryGroup& group) const {
  const GroupPlane plane =
      fitted_plane(model_, {Eigen::Vector3d::Zero(), axis.axis.direction}, options_);
  if (plane.residual <= options_.tolerance &&
      line_angle(plane.plane.normal, axis.axis.direction) < options_.same_angle)
    group.planes.push_back(plane);
  const Eigen::Vector3d across = orthonormal_complement(axis.axis.direction).col(0);
  GroupAxis flip = fitted_axis(model_, {axis.axis.point, across}, 2, options_);
  if (flip.residual <= options_.tolerance &&
      std::abs(flip.axis.direction.dot(axis.axis.direction)) < std::sin(options_.same_angle))
    group.axes.push_back(flip);
}

}  // namespace symscene
