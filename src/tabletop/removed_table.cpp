#include "removed_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fragments.hpp"
#include "plane_patch.hpp"

namespace symscene {
namespace {

/// How a fragment lies to the plane.
struct FragmentHeights {
  double lowest = std::numeric_limits<double>::infinity();  ///< [m]
  std::size_t points = 0;
  std::size_t below = 0;
};

/// The points up to max_height from the table, but for its own.
PointIndices points_around(const PointCloud& cloud, const SupportPlane& table, double max_height) {
  PointIndices around;
  auto own = table.inliers.begin();
  for (Index i = 0; i < cloud.size(); ++i) {
    const bool is_own = own != table.inliers.end() && *own == i;
    if (is_own) ++own;
    const double height = table.plane.signed_distance(cloud.position(i).cast<double>());
    if (!is_own && std::abs(height) < max_height) around.push_back(i);
  }
  return around;
}

/// Where the points of fragments that stand on the plane are above it.
std::vector<Eigen::Vector2d> standing_points(const PointCloud& cloud, const SupportPlane& table,
                                             const TableSceneOptions& options) {
  constexpr std::size_t least_points_per_point_below = 20;
  const PointCloud around = select(cloud, points_around(cloud, table, options.plane.max_height));
  const FragmentBounds bounds = bounds_for(around.positions, options.crop);
  const std::vector<Index> fragment = fragments_of(around.positions, bounds.link);
  std::vector<FragmentHeights> heights(fragment.size());
  for (Index i = 0; i < around.size(); ++i) {
    const double height = table.plane.signed_distance(around.position(i).cast<double>());
    FragmentHeights& of = heights[fragment[i]];
    of.lowest = std::min(of.lowest, std::abs(height));
    of.below += height < -options.plane.inlier_distance ? 1 : 0;
    ++of.points;
  }
  const PlaneFrame frame(table.plane);
  std::vector<Eigen::Vector2d> standing;
  for (Index i = 0; i < around.size(); ++i) {
    const FragmentHeights& of = heights[fragment[i]];
    if (of.points >= bounds.least && of.lowest < options.crop.max_rough_clearance &&
        of.points >= least_points_per_point_below * of.below)
      standing.push_back(frame.within(around.position(i).cast<double>()));
  }
  return standing;
}

}  // namespace

void extend_outline_below_objects(SupportPlane& table, const PointCloud& cloud,
                                  const TableSceneOptions& options) {
  const PlaneFrame frame(table.plane);
  std::vector<Eigen::Vector2d> points = standing_points(cloud, table, options);
  const PlaneCells covered(points, options.plane.cell_size);
  if (covered.area(covered.occupied()) <= table.area) return;
  for (const Eigen::Vector3d& corner : table.outline) points.push_back(frame.within(corner));
  table.outline.clear();
  const ConvexOutline outline(std::move(points));
  for (const Eigen::Vector2d& corner : outline.corners())
    table.outline.push_back(frame.lift(corner));
}

}  // namespace symscene
