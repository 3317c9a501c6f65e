#include "support_plane.hpp"

#include <algorithm>
#include <cmath>

#include "plane_patch.hpp"
#include "plane_search.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr double cell_edge = 0.02;        ///< of the cells that areas are counted in [m]
constexpr double least_distance = 0.003;  ///< within which refinement keeps all points [m]
constexpr int fit_refinements = 2;
constexpr Index points_for_fit = 50000;

PointIndices usable_points(const PointCloud& cloud) {
  if (cloud.size() > 0 && !cloud.has_normals()) {
    throw InputError("point cloud", "points with normals", "none");
  }
  PointIndices usable;
  for (const Index i : oriented_points(cloud)) {
    if (cloud.positions.row(i).allFinite() && cloud.normals.row(i).allFinite()) usable.push_back(i);
  }
  return usable;
}

/// The largest connected patch of the points near a plane whose normals agree with its own.
PointIndices patch_of(const PointCloud& cloud, const PointIndices& usable, const Plane& plane,
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
  const PlaneFrame frame(plane);
  std::vector<Eigen::Vector2d> within;
  within.reserve(near.size());
  for (const Index i : near) within.push_back(frame.within(cloud.position(i).cast<double>()));
  PointIndices patch;
  for (const std::size_t k : PlaneCells(within, cell_edge).largest_patch()) {
    patch.push_back(near[k]);
  }
  return patch;
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
        moments_of(cloud, patch_of(cloud, some, fit.plane, fit.distance, options.normal_angle));
    fit.plane = moments.plane(fit.plane);
    fit.distance =
        std::clamp(options.refined_sigmas * moments.residual(fit.plane),
                   std::min(least_distance, options.inlier_distance), options.inlier_distance);
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
SupportPlane described(const PointCloud& cloud, const Plane& plane, PointIndices inliers) {
  SupportPlane support;
  support.plane = plane;
  support.inliers = std::move(inliers);
  support.residual = moments_of(cloud, support.inliers).residual(plane);
  const PlaneFrame frame(plane);
  std::vector<Eigen::Vector2d> within;
  within.reserve(support.inliers.size());
  for (const Index i : support.inliers) {
    within.push_back(frame.within(cloud.position(i).cast<double>()));
  }
  const PlaneCells cells(within, cell_edge);
  support.area = cells.area(cells.occupied());
  std::vector<Eigen::Vector2d> border;
  for (const std::size_t k : cells.border()) border.push_back(within[k]);
  const ConvexOutline outline(std::move(border));
  for (const Eigen::Vector2d& corner : outline.corners()) {
    support.outline.push_back(frame.lift(corner));
  }
  return support;
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
  for (const Plane& start : dominant_planes(cloud, usable, options)) {
    const PlaneFit fit = fitted(cloud, some, start, options);
    PointIndices patch =
        patch_of(cloud, usable, fit.plane, options.inlier_distance, options.normal_angle);
    const Plane whole = refined(cloud, patch, fit);
    SupportPlane plane = described(cloud, whole, std::move(patch));
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

/// The area of the plane below objects.
double covered_area(const PointCloud& cloud, const PointIndices& usable, const SupportPlane& plane,
                    const std::vector<bool>& walls, const SupportPlaneOptions& options) {
  const PlaneFrame frame(plane.plane);
  std::vector<Eigen::Vector2d> corners;
  for (const Eigen::Vector3d& corner : plane.outline) corners.push_back(frame.within(corner));
  const ConvexOutline outline(std::move(corners));
  const double clearance = std::max(options.min_clearance, options.inlier_distance);
  std::vector<Eigen::Vector2d> above;
  for (const Index i : usable) {
    if (walls[i]) continue;
    const Eigen::Vector3d point = cloud.position(i).cast<double>();
    const double height = plane.plane.signed_distance(point);
    if (!(height > clearance && height < options.max_height)) continue;
    const Eigen::Vector2d within = frame.within(point);
    if (outline.distance(within) < 0.0) above.push_back(within);
  }
  const PlaneCells cells(above, cell_edge);
  return cells.area(cells.occupied());
}

bool may_support(const SupportPlane& plane, const SupportPlaneOptions& options,
                 const std::optional<Eigen::Vector3d>& up) {
  return plane.area >= options.min_area && plane.outline.size() >= 3 &&
         (!up || angle_between(plane.plane.normal, *up) <= options.max_tilt);
}

}  // namespace

void SupportPlaneOptions::validate() const {
  check_fields(*this);
  require_option(max_height > min_clearance, "max_height", "more than min_clearance", max_height);
}

SupportPlanes find_support_planes(const PointCloud& cloud, const SupportPlaneOptions& options,
                                  const std::optional<Eigen::Vector3d>& up) {
  options.validate();
  const PointIndices usable = usable_points(cloud);
  const std::vector<SupportPlane> planes = distinct_planes(cloud, usable, options);
  const std::vector<bool> walls = points_of_walls(cloud, planes, options.wall_area);
  SupportPlanes result;
  for (SupportPlane plane : planes) {
    if (!may_support(plane, options, up)) {
      result.others.push_back(std::move(plane));
      continue;
    }
    plane.object_area = covered_area(cloud, usable, plane, walls, options);
    // An empty table counts as if one cell were covered.
    plane.score = std::sqrt(plane.area * (plane.object_area + cell_edge * cell_edge));
    result.supports.push_back(std::move(plane));
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
  const PointIndices usable = usable_points(cloud);
  const Plane unit{plane.normal / length, plane.offset / length};
  SupportPlane support = described(
      cloud, unit, patch_of(cloud, usable, unit, options.inlier_distance, options.normal_angle));
  support.object_area =
      covered_area(cloud, usable, support, std::vector<bool>(cloud.size(), false), options);
  support.score = std::sqrt(support.area * support.object_area);
  return support;
}

}  // namespace symscene
