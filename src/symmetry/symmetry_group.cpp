#include "symscene/symmetry/symmetry_group.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Dense>

#include "finite_group.hpp"
#include "group_search.hpp"
#include "nearest_point.hpp"
#include "symmetry/greatest_distance.hpp"
#include "symscene/core/error.hpp"
#include "tight_box.hpp"

namespace symscene {
namespace {

constexpr std::size_t max_group = 120;  ///< the icosahedron with its reflections

/// The point nearest to all planes and axes, which every symmetry leaves in place; near `start`
/// where they leave it open.
Eigen::Vector3d common_point(const SymmetryGroup& group, const Eigen::Vector3d& start) {
  NearestPoint common(start, 1e-6);
  for (const GroupPlane& found : group.planes)
    common.add_plane(found.plane.point, found.plane.normal);
  for (const GroupAxis& found : group.axes) common.add_line(found.axis.point, found.axis.direction);
  return common.solve();
}

/// A turn or reflection that generates symmetries.
struct Generator {
  Eigen::Matrix3d matrix;
  double residual;
  bool is_axis;
  std::size_t index;  ///< among the axes or planes of the group
};

std::vector<Generator> generators_of(const SymmetryGroup& group) {
  std::vector<Generator> generators;
  const bool turns_freely =
      !group.axes.empty() && group.axes.front().order == GroupAxis::continuous;
  for (std::size_t k = 0; k < group.axes.size(); ++k) {
    const GroupAxis& found = group.axes[k];
    if (found.order == GroupAxis::continuous) continue;
    generators.push_back(
        {found.axis.rotation(2.0 * std::numbers::pi / found.order), found.residual, true, k});
  }
  // With a continuous axis, the plane across it and the half turn would make more half turns.
  for (std::size_t k = 0; k < group.planes.size() && !turns_freely; ++k) {
    const GroupPlane& found = group.planes[k];
    generators.push_back({motion_of(found.plane).linear(), found.residual, false, k});
  }
  std::stable_sort(generators.begin(), generators.end(),
                   [](const Generator& a, const Generator& b) { return a.residual < b.residual; });
  return generators;
}

/// Whether a group turns the surface about a listed axis by less than the axis' order says: such
/// turns were tried and are no symmetries.
bool exceeds_orders(const FiniteGroup& finite, const std::vector<GroupAxis>& axes,
                    double same_angle) {
  constexpr double whole = 0.25;  // of a multiple of the least turn
  return std::any_of(
      finite.elements().begin(), finite.elements().end(), [&](const Eigen::Matrix3d& element) {
        if (element.determinant() < 0.0) return false;
        const Eigen::AngleAxisd turn(element);
        return std::any_of(axes.begin(), axes.end(), [&](const GroupAxis& listed) {
          const double steps = listed.order * turn.angle() / (2.0 * std::numbers::pi);
          return std::abs(steps - std::round(steps)) > whole &&
                 line_angle(listed.axis.direction, turn.axis()) < same_angle;
        });
      });
}

/// Drops symmetries which, with better ones, generate turns that exceed the order of a listed axis,
/// such as the diagonals of a plate that is nearly square.
void drop_exceeding(const SymmetryGroupOptions& options, SymmetryGroup& group) {
  FiniteGroup finite;
  std::vector<bool> axis_exceeds(group.axes.size()), plane_exceeds(group.planes.size());
  for (const Generator& generator : generators_of(group)) {
    const FiniteGroup larger = finite.with(generator.matrix, max_group);
    if (larger.elements().size() > max_group) continue;
    if (exceeds_orders(larger, group.axes, options.same_angle)) {
      (generator.is_axis ? axis_exceeds : plane_exceeds)[generator.index] = true;
    } else {
      finite = larger;
    }
  }
  const auto erase = [](auto& symmetries, const std::vector<bool>& exceeds) {
    std::size_t k = 0;
    std::erase_if(symmetries, [&](const auto&) { return exceeds[k++]; });
  };
  erase(group.axes, axis_exceeds);
  erase(group.planes, plane_exceeds);
}

/// The largest group of the generators, best first, whose elements are all symmetries.
FiniteGroup closed_group(const SymmetryModel& model, const SymmetryGroup& found,
                         const Eigen::Vector3d& center, const SymmetryGroupOptions& options) {
  const double tolerance = options.product_ratio * options.tolerance;
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
          return mean_distance(model.surface, model.judged, motion) <= tolerance;
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

void search(const SymmetryModel& model, const SymmetryGroupOptions& options, SymmetryGroup& group) {
  const GroupSearch search(model, options);
  const std::vector<GroupAxis> continuous = search.axes(GroupAxis::continuous);
  if (!continuous.empty()) {
    group.axes.push_back(continuous.front());
    search.complete(continuous.front(), group);
  } else {
    group.axes = search.finite_axes();
    group.planes = search.planes();
  }
  drop_exceeding(options, group);
  group.center = common_point(group, Eigen::Vector3d::Zero());
  const FiniteGroup closed = closed_group(model, group, group.center, options);
  for (const Eigen::Matrix3d& element : closed.elements()) {
    if (element.determinant() < 0.0 || element.trace() > 2.999) continue;
    group.rotations.push_back(Eigen::Isometry3d::Identity());
    group.rotations.back().linear() = element;
  }
}

/// Options for a surface with a diameter of one.
SymmetryGroupOptions in_diameters(const SymmetryGroupOptions& options, const SymmetryGroup& group) {
  SymmetryGroupOptions normalised = options;
  const double diagonal = group.diagonal / group.diameter;
  normalised.tolerance *= diagonal;
  normalised.part_distance *= diagonal;
  return normalised;
}

}  // namespace

SymmetryGroup find_symmetry_group(const PointCloud& surface, const SymmetryGroupOptions& options) {
  options.validate();
  SymmetryGroup group;
  group.diameter = greatest_distance(surface.positions);
  require_surface(surface, group.diameter);
  group.diagonal = tight_box_diagonal(surface.positions);
  const Eigen::Vector3d origin = centroid(surface.positions);
  const PointCloud cloud = normalized(surface, origin, group.diameter);
  group.sphere_residual = radius_deviation(cloud);
  const SymmetryGroupOptions normalised = in_diameters(options, group);
  group.sphere = group.sphere_residual <= normalised.tolerance;
  if (!group.sphere) search(SymmetryModel(cloud, normalised), normalised, group);
  restore(group, origin);
  return group;
}

}  // namespace symscene
