#include "symscene/symmetry/symmetry_group.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <Eigen/Dense>

#include "core/parallel.hpp"
#include "core/voxel_sampling.hpp"
#include "finite_group.hpp"
#include "motion_fit.hpp"
#include "surface_distance.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/normal_estimation.hpp"

namespace symscene {
namespace {

/// Candidates are the minima of the coarse distance within this angle, up to a number.
const double candidate_angle = radians(7.0);
constexpr std::size_t max_candidates = 16;
/// A direction between those that are tried moves the surface by up to this, by the diameter.
constexpr double step_distance = 0.02;
/// Fitted candidates within this angle of a better one are duplicates.
const double same_angle = radians(5.0);
/// A symmetry is a minimum of the residual: not one that improves if tilted by this.
const double tilt_angle = radians(4.0);
/// An order is accepted if its residual is at most this multiple of the residual of the best order.
constexpr double order_ratio = 3.0;
constexpr std::size_t max_group = 120;  ///< the icosahedron with its reflections
constexpr int spread_directions = 1000;

/// Directions evenly spread over a hemisphere (Fibonacci lattice; Swinbank and Purser 2006).
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

/// The turns of an axis up to a half, as those beyond are their inverses.
std::vector<double> angles_of(int order) {
  // Multiples of no turn of a low order.
  constexpr int parts = 15;
  const int n = order == GroupAxis::continuous ? parts : order;
  std::vector<double> angles;
  for (int k = 1; 2 * k <= n; ++k) angles.push_back(2.0 * std::numbers::pi * k / n);
  return angles;
}

/// A surface of diameter one about its centroid, and the samples of it that are moved.
struct Model {
  Model(const PointCloud& cloud, const SymmetryGroupOptions& options)
      : surface(cloud),
        coarse(evenly_spread(cloud.size(), static_cast<Index>(options.coarse_points))),
        fitted(evenly_spread(cloud.size(), static_cast<Index>(options.fit_points))),
        judged(evenly_spread(cloud.size(), static_cast<Index>(options.residual_points))) {}

  double residual(const ReflectionPlane& plane) const {
    return mean_distance(surface, judged, motion_of(plane));
  }
  double residual(const RotationAxis& axis, const std::vector<double>& angles) const {
    return mean_distance(surface, judged, axis, angles);
  }

  SurfaceDistance surface;
  PointIndices coarse, fitted, judged;
};

/// Whether a residual grows when the direction is tilted to any side.
template <class Residual>
bool is_minimum(const Eigen::Vector3d& direction, double residual, const Residual& residual_of) {
  const Eigen::Matrix<double, 3, 2> basis = orthonormal_complement(direction);
  for (int k = 0; k < 8; ++k) {
    const double turn = k * std::numbers::pi / 4.0;
    const Eigen::Vector3d side = basis * Eigen::Vector2d(std::cos(turn), std::sin(turn));
    if (residual_of((direction + std::tan(tilt_angle) * side).normalized()) < residual)
      return false;
  }
  return true;
}

constexpr double never = std::numeric_limits<double>::infinity();

/// Fitted to the surface; with an infinite residual if it is far from a symmetry.
GroupPlane fitted_plane(const Model& model, const ReflectionPlane& start, double tolerance) {
  ReflectionPlane plane = fit_to(model.surface, model.coarse, start, Matching::coarse);
  if (mean_distance(model.surface, model.coarse, motion_of(plane), Matching::coarse) >
      tolerance + step_distance)
    return {plane, never};
  plane = fit_to(model.surface, model.fitted, plane, Matching::exact);
  return {plane, model.residual(plane)};
}

GroupAxis fitted_axis(const Model& model, const RotationAxis& start, int order, double tolerance) {
  const std::vector<double> angles = angles_of(order);
  RotationAxis axis = fit_to(model.surface, model.coarse, start, angles, Matching::coarse);
  if (mean_distance(model.surface, model.coarse, axis, angles, Matching::coarse) >
      tolerance + step_distance)
    return {axis, order, never};
  axis = fit_to(model.surface, model.fitted, axis, angles, Matching::exact);
  return {axis, order, model.residual(axis, angles)};
}

const Eigen::Vector3d& direction_of(const GroupPlane& found) { return found.plane.normal; }
const Eigen::Vector3d& direction_of(const GroupAxis& found) { return found.axis.direction; }

/// Those within the tolerance, best first, without those near a better one.
template <class Symmetry>
std::vector<Symmetry> distinct(std::vector<Symmetry> found, double tolerance) {
  std::stable_sort(found.begin(), found.end(),
                   [](const Symmetry& a, const Symmetry& b) { return a.residual < b.residual; });
  std::vector<Symmetry> kept;
  for (const Symmetry& symmetry : found) {
    if (!(symmetry.residual <= tolerance)) continue;
    const bool is_new = std::none_of(kept.begin(), kept.end(), [&](const Symmetry& other) {
      return line_angle(direction_of(symmetry), direction_of(other)) < same_angle;
    });
    if (is_new) kept.push_back(symmetry);
  }
  return kept;
}

/// The search for the symmetries of a model with some directions.
class GroupSearch {
 public:
  GroupSearch(const Model& model, const SymmetryGroupOptions& options)
      : model_(model), options_(options), directions_(hemisphere(options.directions)) {}

  std::vector<GroupPlane> planes() const {
    const std::vector<Eigen::Vector3d> normals = candidates([&](const Eigen::Vector3d& normal) {
      return mean_distance(model_.surface, model_.coarse,
                           motion_of(ReflectionPlane{Eigen::Vector3d::Zero(), normal}),
                           Matching::coarse);
    });
    std::vector<GroupPlane> found(normals.size());
    parallel_for_each(normals.size(), [&](std::size_t k) {
      found[k] = fitted_plane(model_, {Eigen::Vector3d::Zero(), normals[k]}, options_.tolerance);
    });
    found = distinct(std::move(found), options_.tolerance);
    std::erase_if(found, [&](const GroupPlane& plane) {
      return !is_minimum(plane.plane.normal, plane.residual, [&](const Eigen::Vector3d& normal) {
        return model_.residual(ReflectionPlane{plane.plane.point, normal});
      });
    });
    return found;
  }

  /// The axes of an order, best first.
  std::vector<GroupAxis> axes(int order) const {
    // The first angle makes all turns of an order; two suffice for a continuous axis.
    std::vector<double> tried = angles_of(order);
    tried.resize(order == GroupAxis::continuous ? 2 : 1);
    const std::vector<Eigen::Vector3d> starts = candidates([&](const Eigen::Vector3d& direction) {
      return mean_distance(model_.surface, model_.coarse, {Eigen::Vector3d::Zero(), direction},
                           tried, Matching::coarse);
    });
    const std::vector<double> angles = angles_of(order);
    std::vector<GroupAxis> found(starts.size());
    parallel_for_each(starts.size(), [&](std::size_t k) {
      found[k] =
          fitted_axis(model_, {Eigen::Vector3d::Zero(), starts[k]}, order, options_.tolerance);
    });
    found = distinct(std::move(found), options_.tolerance);
    std::erase_if(found, [&](const GroupAxis& axis) {
      return !is_minimum(axis.axis.direction, axis.residual, [&](const Eigen::Vector3d& direction) {
        return model_.residual(RotationAxis{axis.axis.point, direction}, angles);
      });
    });
    return found;
  }

  /// Axes of all orders, one per direction.
  std::vector<GroupAxis> finite_axes() const {
    std::vector<GroupAxis> all;
    for (int order = 2; order <= options_.max_order; ++order) {
      const std::vector<GroupAxis> found = axes(order);
      all.insert(all.end(), found.begin(), found.end());
    }
    std::vector<GroupAxis> kept;
    for (const GroupAxis& best : distinct(all, options_.tolerance)) {
      // Turns that are within the tolerance only because they are small do not count.
      const double bound = std::max(order_ratio * best.residual, options_.tolerance / 3.0);
      GroupAxis highest = best;
      for (const GroupAxis& other : all) {
        if (line_angle(other.axis.direction, best.axis.direction) < same_angle &&
            other.residual <= bound && other.order > highest.order)
          highest = other;
      }
      kept.push_back(highest);
    }
    std::stable_sort(kept.begin(), kept.end(),
                     [](const GroupAxis& a, const GroupAxis& b) { return a.order > b.order; });
    return kept;
  }

  /// What a surface of revolution has beside its axis: a plane and half turns across it.
  void complete(const GroupAxis& axis, SymmetryGroup& group) const {
    const GroupPlane plane =
        fitted_plane(model_, {Eigen::Vector3d::Zero(), axis.axis.direction}, options_.tolerance);
    if (plane.residual <= options_.tolerance &&
        line_angle(plane.plane.normal, axis.axis.direction) < same_angle)
      group.planes.push_back(plane);
    const Eigen::Vector3d across = orthonormal_complement(axis.axis.direction).col(0);
    GroupAxis flip = fitted_axis(model_, {axis.axis.point, across}, 2, options_.tolerance);
    if (flip.residual <= options_.tolerance &&
        std::abs(flip.axis.direction.dot(axis.axis.direction)) < std::sin(same_angle))
      group.axes.push_back(flip);
  }

 private:
  /// The minima of a distance over all directions that may be within the tolerance, best first.
  template <class Distance>
  std::vector<Eigen::Vector3d> candidates(const Distance& distance_of) const {
    constexpr std::size_t block = 64;
    std::vector<double> distances(directions_.size());
    parallel_for_blocks(distances.size(), block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) distances[k] = distance_of(directions_[k]);
    });
    std::vector<std::size_t> minima;
    for (std::size_t k = 0; k < distances.size(); ++k) {
      if (distances[k] <= options_.tolerance + step_distance && is_least_around(k, distances))
        minima.push_back(k);
    }
    std::stable_sort(minima.begin(), minima.end(),
                     [&](std::size_t a, std::size_t b) { return distances[a] < distances[b]; });
    minima.resize(std::min(minima.size(), max_candidates));
    std::vector<Eigen::Vector3d> best;
    for (const std::size_t k : minima) best.push_back(directions_[k]);
    return best;
  }

  bool is_least_around(std::size_t k, const std::vector<double>& distances) const {
    const double cosine = std::cos(candidate_angle);
    for (std::size_t other = 0; other < distances.size(); ++other) {
      if (distances[other] < distances[k] &&
          std::abs(directions_[other].dot(directions_[k])) > cosine)
        return false;
    }
    return true;
  }

  const Model& model_;
  const SymmetryGroupOptions& options_;
  std::vector<Eigen::Vector3d> directions_;
};

/// The point nearest to all planes and axes, which every symmetry leaves in place; near `start`
/// where they leave it open.
Eigen::Vector3d common_point(const SymmetryGroup& group, const Eigen::Vector3d& start) {
  constexpr double open = 1e-6;
  Eigen::Matrix3d sum = open * Eigen::Matrix3d::Identity();
  Eigen::Vector3d target = open * start;
  const auto add = [&](const Eigen::Matrix3d& across, const Eigen::Vector3d& point) {
    sum += across;
    target += across * point;
  };
  for (const GroupPlane& found : group.planes)
    add(found.plane.normal * found.plane.normal.transpose(), found.plane.point);
  for (const GroupAxis& found : group.axes) {
    const Eigen::Vector3d& d = found.axis.direction;
    add(Eigen::Matrix3d::Identity() - d * d.transpose(), found.axis.point);
  }
  return sum.ldlt().solve(target);
}

/// A turn or reflection that generates symmetries.
struct Generator {
  Eigen::Matrix3d matrix;
  double residual;
};

std::vector<Generator> generators_of(const SymmetryGroup& group) {
  std::vector<Generator> generators;
  const bool turns_freely =
      !group.axes.empty() && group.axes.front().order == GroupAxis::continuous;
  for (const GroupAxis& found : group.axes) {
    if (found.order == GroupAxis::continuous) continue;
    generators.push_back(
        {found.axis.rotation(2.0 * std::numbers::pi / found.order), found.residual});
  }
  // With a continuous axis, the plane across it and the half turn would make more half turns.
  for (const GroupPlane& found : group.planes) {
    if (!turns_freely) generators.push_back({motion_of(found.plane).linear(), found.residual});
  }
  std::stable_sort(generators.begin(), generators.end(),
                   [](const Generator& a, const Generator& b) { return a.residual < b.residual; });
  return generators;
}

/// The largest group of the generators, best first, whose elements are all symmetries.
FiniteGroup closed_group(const Model& model, const SymmetryGroup& found,
                         const Eigen::Vector3d& center, double tolerance) {
  constexpr double slack = 1.5;  // products add up the errors of their factors
  FiniteGroup group;
  for (const Generator& generator : generators_of(found)) {
    const FiniteGroup larger = group.with(generator.matrix, max_group);
    if (larger.elements().size() > max_group) continue;
    const FiniteGroup exact = larger.exact();
    const bool holds = std::all_of(
        exact.elements().begin(), exact.elements().end(), [&](const Eigen::Matrix3d& element) {
          Eigen::Affine3d motion = Eigen::Affine3d::Identity();
          motion.linear() = element;
          motion.translation() = center - element * center;
          return mean_distance(model.surface, model.judged, motion) <= slack * tolerance;
        });
    if (holds) group = larger;
  }
  return group.exact();
}

/// The mean deviation of radii about the centroid, of a surface about it with diameter one.
double radius_deviation(const PointCloud& surface) {
  const Eigen::VectorXf radii = surface.positions.rowwise().norm();
  return double{(radii.array() - radii.mean()).abs().mean()};
}

/// The cloud about its centroid, with a diameter of one.
PointCloud normalized(const PointCloud& surface, const Eigen::Vector3d& center, double diameter) {
  PointCloud cloud = surface;
  cloud.positions.rowwise() -= center.cast<float>().transpose();
  cloud.positions /= static_cast<float>(diameter);
  return cloud;
}

void require_surface(const PointCloud& surface, double diameter) {
  if (surface.empty() || !std::isfinite(diameter) || !(diameter > 0.0))
    throw InputError("surface", "points that span a finite extent",
                     std::to_string(surface.size()) + " points that do not");
  if (oriented_points(surface).size() != surface.size())
    throw InputError("surface", "a normal at every point", "points without");
}

/// From the normalised frame into that of the surface.
void restore(SymmetryGroup& group, const Eigen::Vector3d& origin) {
  const auto restored = [&](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(origin + group.diameter * p);
  };
  group.center = restored(group.center);
  group.sphere_residual *= group.diameter;
  for (GroupAxis& found : group.axes) {
    found.axis.point = restored(found.axis.point);
    found.residual *= group.diameter;
  }
  for (GroupPlane& found : group.planes) {
    found.plane.point = restored(found.plane.point);
    found.residual *= group.diameter;
  }
  for (Eigen::Isometry3d& rotation : group.rotations)
    rotation.translation() = group.center - rotation.linear() * group.center;
}

void search(const Model& model, const SymmetryGroupOptions& options, SymmetryGroup& group) {
  const GroupSearch search(model, options);
  const std::vector<GroupAxis> continuous = search.axes(GroupAxis::continuous);
  if (!continuous.empty()) {
    group.axes.push_back(continuous.front());
    search.complete(continuous.front(), group);
  } else {
    group.axes = search.finite_axes();
    group.planes = search.planes();
  }
  group.center = common_point(group, Eigen::Vector3d::Zero());
  const FiniteGroup closed = closed_group(model, group, group.center, options.tolerance);
  for (const Eigen::Matrix3d& element : closed.elements()) {
    if (element.determinant() < 0.0 || element.trace() > 2.999) continue;
    group.rotations.push_back(Eigen::Isometry3d::Identity());
    group.rotations.back().linear() = element;
  }
}

}  // namespace

SymmetryGroup find_symmetry_group(const PointCloud& surface, const SymmetryGroupOptions& options) {
  options.validate();
  SymmetryGroup group;
  group.diameter = greatest_distance(surface.positions);
  require_surface(surface, group.diameter);
  const Eigen::Vector3d origin = centroid(surface.positions);
  const PointCloud cloud = normalized(surface, origin, group.diameter);
  group.sphere_residual = radius_deviation(cloud);
  group.sphere = group.sphere_residual <= options.tolerance;
  if (!group.sphere) search(Model(cloud, options), options, group);
  restore(group, origin);
  return group;
}

double greatest_distance(const Points& points) {
  if (points.rows() == 0) return 0.0;
  // Only points that are outermost in some direction can be farthest apart.
  std::vector<Index> outermost;
  for (const Eigen::Vector3d& direction : hemisphere(spread_directions)) {
    const Eigen::VectorXf along = points * direction.cast<float>();
    Eigen::Index low = 0, high = 0;
    along.minCoeff(&low);
    along.maxCoeff(&high);
    outermost.insert(outermost.end(), {static_cast<Index>(low), static_cast<Index>(high)});
  }
  std::sort(outermost.begin(), outermost.end());
  outermost.erase(std::unique(outermost.begin(), outermost.end()), outermost.end());
  float squared = 0.0F;
  for (const Index a : outermost) {
    for (const Index b : outermost)
      squared = std::max(squared, (points.row(a) - points.row(b)).squaredNorm());
  }
  return std::sqrt(double{squared});
}

PointCloud even_surface(const PointCloud& cloud) {
  constexpr double spacing = 0.008;  // by the diameter
  const PointCloud finite = select(cloud, finite_points(cloud.positions));
  const double diameter = greatest_distance(finite.positions);
  if (!(diameter > 0.0) || !std::isfinite(diameter))
    throw InputError("object", "points that span a finite extent",
                     std::to_string(cloud.size()) + " points that do not");
  PointCloud even = voxel_downsample(finite, spacing * diameter);
  if (oriented_points(even).empty()) {
    const Eigen::Vector3f center = centroid(even.positions).cast<float>();
    even.normals = estimate_normals(even.positions, [&](const auto& at, const auto& direction) {
      return double{direction.dot(at - center)};
    });
  }
  even = select(even, oriented_points(even));
  if (even.empty()) throw InputError("object", "a surface with normals", "points that span none");
  return even;
}

}  // namespace symscene
