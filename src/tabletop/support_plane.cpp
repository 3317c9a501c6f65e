#include "support_plane.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/parallel.hpp"
#include "plane_patch.hpp"
#include "plane_search.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr int fit_refinements = 2;
constexpr Index points_for_fit = 50000;

PointIndices usable_points(const PointCloud& cloud) {
  if (!cloud.empty() && !cloud.has_normals()) {
    throw InputError("point cloud", "points with normals", "none");
  }
  PointIndices usable;
  for (const Index i : oriented_points(cloud)) {
    if (cloud.positions.row(i).allFinite() && cloud.normals.row(i).allFinite()) usable.push_back(i);
  }
  return usable;
}

/// The points near a plane whose normals agree with its own.
PointIndices points_near(const PointCloud& cloud, const PointIndices& usable, const Plane& plane,
                         double distance, double normal_angle) {
  const auto cosine = static_cast<float>(std::cos(normal_angle));
  const Eigen::Vector3f normal = plane.normal.cast<float>();
  const auto offset = static_cast<float>(plane.offset);
  const auto reach = static_cast<float>(distance);
  PointIndices near;
  for (const Index i : usable) {
    if (std::abs(normal.dot(cloud.position(i)) + offset) < reach &&
        normal.dot(cloud.normal(i)) > cosine) {
      near.push_back(i);
    }
  }
  return near;
}

std::vector<Eigen::Vector2d> within_plane(const PointCloud& cloud, const PointIndices& points,
                                          const Plane& plane) {
  const PlaneFrame frame(plane);
  std::vector<Eigen::Vector2d> within;
  within.reserve(points.size());
  for (const Index i : points) within.push_back(frame.within(cloud.position(i).cast<double>()));
  return within;
}

/// The largest connected patch of the points near a plane whose normals agree with its own.
PointIndices patch_of(const PointCloud& cloud, const PointIndices& usable, const Plane& plane,
                      double distance, const SupportPlaneOptions& options) {
  const PointIndices near = points_near(cloud, usable, plane, distance, options.normal_angle);
  PointIndices patch;
  const PlaneCells cells(within_plane(cloud, near, plane), options.cell_size);
  for (const std::size_t k : cells.largest_patch()) patch.push_back(near[k]);
  return patch;
}

/// All patches of a table.
PointIndices patches_of(const PointCloud& cloud, const PointIndices& usable, const Plane& plane,
                        const SupportPlaneOptions& options) {
  const PointIndices near =
      points_near(cloud, usable, plane, options.inlier_distance, options.normal_angle);
  const std::vector<Eigen::Vector2d> within = within_plane(cloud, near, plane);
  PointIndices patches;
  for (const std::size_t k :
       PlaneCells(within, options.cell_size).table_patches(within, options.patch_gap))
    patches.push_back(near[k]);
  return patches;
}

PlaneMoments moments_of(const PointCloud& cloud, const PointIndices& points) {
  PlaneMoments moments;
  for (const Index i : points) moments.add(cloud.position(i).cast<double>());
  return moments;
}

/// A plane and the distance within which points are fitted.
struct PlaneFit {
  Plane plane;
  double distance = 0.0;  ///< [m]
};

/// Least squares on the patch of some of the points. Objects on the table drop out, as their points
/// are farther off than the roughness of the patch.
PlaneFit fitted(const PointCloud& cloud, const PointIndices& some, const Plane& start,
                const SupportPlaneOptions& options) {
  PlaneFit fit{start, options.inlier_distance};
  for (int round = 0; round < fit_refinements; ++round) {
    const PlaneMoments moments =
        moments_of(cloud, patch_of(cloud, some, fit.plane, fit.distance, options));
    fit.plane = moments.plane(fit.plane);
    fit.distance = std::clamp(options.refined_sigmas * moments.residual(fit.plane),
                              std::min(options.min_refined_distance, options.inlier_distance),
                              options.inlier_distance);
  }
  return fit;
}

/// Least squares on all points within the distance of the fit.
Plane refined(const PointCloud& cloud, const PointIndices& patch, const PlaneFit& fit) {
  PlaneMoments moments;
  for (const Index i : patch) {
    const Eigen::Vector3d point = cloud.position(i).cast<double>();
    if (std::abs(fit.plane.signed_distance(point)) < fit.distance) moments.add(point);
  }
  return moments.plane(fit.plane);
}

/// The residual, area and outline of a plane with these inliers.
SupportPlane described(const PointCloud& cloud, const Plane& plane, PointIndices inliers,
                       const SupportPlaneOptions& options) {
  SupportPlane support;
  support.plane = plane;
  support.inliers = std::move(inliers);
  support.residual = moments_of(cloud, support.inliers).residual(plane);
  const PlaneFrame frame(plane);
  const std::vector<Eigen::Vector2d> within = within_plane(cloud, support.inliers, plane);
  const PlaneCells cells(within, options.cell_size);
  support.area = cells.area(cells.occupied());
  std::vector<Eigen::Vector2d> border;
  for (const std::size_t k : cells.border()) border.push_back(within[k]);
  const ConvexOutline outline(std::move(border));
  for (const Eigen::Vector2d& corner : outline.corners()) {
    support.outline.push_back(frame.lift(corner));
  }
  return support;
}

/// A plane of the search fitted to the points of its patch. `some` are those that it starts from.
SupportPlane patch_plane(const PointCloud& cloud, const PointIndices& usable,
                         const PointIndices& some, const Plane& start,
                         const SupportPlaneOptions& options) {
  const PlaneFit fit = fitted(cloud, some, start, options);
  PointIndices patch = patch_of(cloud, usable, fit.plane, options.inlier_distance, options);
  const Plane whole = refined(cloud, patch, fit);
  return described(cloud, whole, std::move(patch), options);
}

/// The planes of the cloud. Two results of the search may be refined to the same plane; the second
/// is dropped.
std::vector<SupportPlane> distinct_planes(const PointCloud& cloud, const PointIndices& usable,
                                          const SupportPlaneOptions& options) {
  std::vector<SupportPlane> planes;
  std::vector<bool> taken(cloud.size(), false);
  PointIndices some;
  for (const Index k : evenly_spread(static_cast<Index>(usable.size()), points_for_fit)) {
    some.push_back(usable[k]);
  }
  const std::vector<Plane> starts = dominant_planes(cloud, usable, options);
  std::vector<SupportPlane> found(starts.size());
  parallel_for_each(starts.size(), [&](std::size_t k) {
    found[k] = patch_plane(cloud, usable, some, starts[k], options);
  });
  for (SupportPlane& plane : found) {
    const auto known = std::count_if(plane.inliers.begin(), plane.inliers.end(),
                                     [&](Index i) { return taken[i]; });
    if (2 * static_cast<std::size_t>(known) > plane.inliers.size()) continue;
    for (const Index i : plane.inliers) taken[i] = true;
    planes.push_back(std::move(plane));
  }
  return planes;
}

/// Points of planes too large to be faces of objects.
std::vector<bool> points_of_walls(const PointCloud& cloud, const std::vector<SupportPlane>& planes,
                                  double wall_area) {
  std::vector<bool> walls(cloud.size(), false);
  for (const SupportPlane& plane : planes) {
    if (plane.area < wall_area) continue;
    for (const Index i : plane.inliers) walls[i] = true;
  }
  return walls;
}

/// The cells of the plane below objects.
PlaneCells covered_cells(const PointCloud& cloud, const PointIndices& usable,
                         const SupportPlane& plane, const std::vector<bool>& walls,
                         const SupportPlaneOptions& options) {
  const PlaneFrame frame(plane.plane);
  const ConvexOutline outline = outline_of(plane.outline, frame);
  std::vector<Eigen::Vector2d> above;
  for (const Index i : usable) {
    if (walls[i]) continue;
    const Eigen::Vector3d point = cloud.position(i).cast<double>();
    const double height = plane.plane.signed_distance(point);
    if (!(height > options.inlier_distance && height < options.max_height)) continue;
    const Eigen::Vector2d within = frame.within(point);
    if (outline.distance(within) < 0.0) above.push_back(within);
  }
  return {above, options.cell_size};
}

/// The number of points just below the plane and its outline, of surfaces at an angle to it: a bent
/// table is below its own plane too.
std::size_t points_beneath(const PointCloud& cloud, const PointIndices& usable,
                           const SupportPlane& plane, const SupportPlaneOptions& options) {
  const PlaneFrame frame(plane.plane);
  const ConvexOutline outline = outline_of(plane.outline, frame);
  return static_cast<std::size_t>(std::count_if(usable.begin(), usable.end(), [&](Index i) {
    const Eigen::Vector3d point = cloud.position(i).cast<double>();
    const double below = -plane.plane.signed_distance(point);
    return below > 1.5 * options.inlier_distance && below < options.beneath_depth &&
           plane.plane.normal.dot(cloud.normal(i).cast<double>()) < options.beneath_cosine &&
           outline.distance(frame.within(point)) < options.beneath_margin;
  }));
}

/// At most this many viewpoints, evenly spread, are looked from.
constexpr Index viewpoints_used = 16;

std::vector<Eigen::Vector3d> some_viewpoints(const TablePrior& known) {
  std::vector<Eigen::Vector3d> some;
  for (const Index k : evenly_spread(static_cast<Index>(known.viewpoints.size()), viewpoints_used))
    some.push_back(known.viewpoints[k]);
  return some;
}

/// The extent of cells of a plane: the mean solid angle in which the cameras see them [sr], or
/// their area [m²] without cameras.
double extent(const PlaneCells& cells, const Plane& plane,
              const std::vector<Eigen::Vector3d>& viewpoints, double cell_size) {
  if (viewpoints.empty()) return cells.area(cells.occupied());
  const PlaneFrame frame(plane);
  double sum = 0.0;
  cells.for_each_occupied([&](const Eigen::Vector2d& middle) {
    const Eigen::Vector3d cell = frame.lift(middle);
    for (const Eigen::Vector3d& viewpoint : viewpoints) {
      const double distance = std::max((viewpoint - cell).norm(), cell_size);
      sum += std::max(plane.signed_distance(viewpoint), 0.0) / std::pow(distance, 3);
    }
  });
  return cells.area(1) * sum / static_cast<double>(viewpoints.size());
}

/// Whether the cameras look onto the plane rather than along it.
bool faces(const SupportPlane& plane, const std::vector<Eigen::Vector3d>& viewpoints,
           const SupportPlaneOptions& options) {
  if (viewpoints.empty() || plane.outline.empty()) return false;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero(), viewpoint = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& corner : plane.outline) middle += corner;
  for (const Eigen::Vector3d& position : viewpoints) viewpoint += position;
  middle /= static_cast<double>(plane.outline.size());
  viewpoint /= static_cast<double>(viewpoints.size());
  return angle_between(plane.plane.normal, viewpoint - middle) <= options.facing_angle;
}

/// The factor of a plane's score that its direction gives: 0 if it is no table.
double direction_factor(const SupportPlane& plane, const SupportPlaneOptions& options,
                        const TablePrior& known) {
  if (plane.area < options.min_area || plane.outline.size() < 3) return 0.0;
  if (!known.up) return 1.0;
  if (angle_between(plane.plane.normal, *known.up) <= options.max_tilt) return 1.0;
  return faces(plane, known.viewpoints, options) ? options.facing_factor : 0.0;
}

/// What the planes of a cloud are measured with.
struct PlaneContext {
  const PointCloud& cloud;
  PointIndices usable;      ///< points with normals
  std::vector<bool> walls;  ///< points of planes too large to be faces of objects
  const SupportPlaneOptions& options;
  const TablePrior& known;
};

/// A plane as a table: all its patches, the objects on it, and the score.
SupportPlane as_support(const PlaneContext& context, const Plane& plane) {
  const auto& [cloud, usable, walls, options, known] = context;
  SupportPlane support =
      described(cloud, plane, patches_of(cloud, usable, plane, options), options);
  const PlaneCells covered = covered_cells(cloud, usable, support, walls, options);
  support.object_area = covered.area(covered.occupied());
  support.beneath = static_cast<double>(points_beneath(cloud, usable, support, options)) /
                    std::max(static_cast<double>(support.inliers.size()), 1.0);
  const std::vector<Eigen::Vector3d> viewpoints = some_viewpoints(known);
  const PlaneCells cells(within_plane(cloud, support.inliers, plane), options.cell_size);
  const double whole = extent(cells, plane, viewpoints, options.cell_size);
  // An empty table counts as if one cell of the mean solid angle were covered.
  const double one = whole / std::max(static_cast<double>(cells.occupied()), 1.0);
  support.score = std::sqrt(whole * (extent(covered, plane, viewpoints, options.cell_size) + one));
  return support;
}

/// Those of the planes that may be tables as tables, one entry per plane.
std::vector<std::optional<SupportPlane>> supports_among(const std::vector<SupportPlane>& planes,
                                                        const PlaneContext& context) {
  std::vector<std::optional<SupportPlane>> supports(planes.size());
  parallel_for_each(planes.size(), [&](std::size_t k) {
    const double factor = direction_factor(planes[k], context.options, context.known);
    if (factor == 0.0) return;
    SupportPlane support = as_support(context, planes[k].plane);
    support.score *= factor;
    support.is_tilted = factor < 1.0;
    if (support.beneath <= context.options.max_beneath) supports[k] = std::move(support);
  });
  return supports;
}

}  // namespace

void SupportPlaneOptions::validate() const {
  check_fields(*this);
  require_option(max_height > inlier_distance, "max_height", "more than inlier_distance",
                 max_height);
}

SupportPlanes find_support_planes(const PointCloud& cloud, const SupportPlaneOptions& options,
                                  const TablePrior& known) {
  options.validate();
  PlaneContext context{cloud, usable_points(cloud), {}, options, known};
  const std::vector<SupportPlane> planes = distinct_planes(cloud, context.usable, options);
  context.walls = points_of_walls(cloud, planes, options.wall_area);
  SupportPlanes result;
  std::vector<std::optional<SupportPlane>> supports = supports_among(planes, context);
  for (std::size_t k = 0; k < planes.size(); ++k) {
    if (supports[k]) {
      result.supports.push_back(std::move(*supports[k]));
    } else {
      result.others.push_back(planes[k]);
    }
  }
  std::stable_sort(result.supports.begin(), result.supports.end(),
                   [](const SupportPlane& a, const SupportPlane& b) { return a.score > b.score; });
  if (result.supports.empty()) return result;
  const bool rivals = result.supports.size() > 1 &&
                      result.supports[1].score >= options.ambiguity * result.supports[0].score;
  result.status = rivals ? SupportStatus::several : SupportStatus::found;
  return result;
}

SupportPlane measure_support_plane(const PointCloud& cloud, const Plane& plane,
                                   const SupportPlaneOptions& options) {
  options.validate();
  const double length = plane.normal.norm();
  if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(plane.offset)) {
    throw InputError("plane", "finite numbers a b c d with a normal", "others");
  }
  const TablePrior known;
  return as_support(
      {cloud, usable_points(cloud), std::vector<bool>(cloud.size(), false), options, known},
      {plane.normal / length, plane.offset / length});
}

}  // namespace symscene
