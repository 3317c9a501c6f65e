#include "symscene/tabletop/table_scene.hpp"

#include <algorithm>
#include <numeric>

#include "bent_plane.hpp"
#include "core/voxel_sampling.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

constexpr double residuals_cleared = 3.0;  ///< of the table's roughness, below the clearance
constexpr Index points_for_bend = 20000;

ConvexOutline outline_of(const SupportPlane& table, const PlaneFrame& frame) {
  std::vector<Eigen::Vector2d> corners;
  for (const Eigen::Vector3d& corner : table.outline) corners.push_back(frame.within(corner));
  return ConvexOutline(std::move(corners));
}

PointCloud points_over(const PointCloud& cloud, const BentPlane& table,
                       const ConvexOutline& outline, const std::vector<SupportPlane>& walls,
                       double clearance, const TableCropOptions& options) {
  std::vector<bool> left_out(cloud.size(), false);
  for (const SupportPlane& wall : walls) {
    if (wall.area < wall_area) continue;
    for (const Index i : wall.inliers) left_out[i] = true;
  }
  PointIndices over;
  for (const Index i : finite_points(cloud.positions)) {
    if (left_out[i]) continue;
    const Eigen::Vector3d point = cloud.position(i).cast<double>();
    const double height = table.height(point);
    if (height > clearance && height < options.max_height &&
        outline.distance(table.frame().within(point)) < options.overhang) {
      over.push_back(i);
    }
  }
  return select(cloud, over);
}

/// The fragment of each point, numbered by their first points.
std::vector<Index> fragments_of(const PointCloud& cloud, double link) {
  std::vector<Index> fragment(cloud.size());
  if (cloud.empty()) return fragment;
  const auto radius = static_cast<float>(link);
  const NeighborLists neighbors = radius_neighbors(cloud.positions, radius);
  std::fill(fragment.begin(), fragment.end(), cloud.size());
  std::vector<Index> open;
  Index count = 0;
  for (Index seed = 0; seed < cloud.size(); ++seed) {
    if (fragment[seed] != cloud.size()) continue;
    fragment[seed] = count;
    open.push_back(seed);
    while (!open.empty()) {
      const Index i = open.back();
      open.pop_back();
      for (const Index other : neighbors.of(i)) {
        if (fragment[other] != cloud.size()) continue;
        fragment[other] = count;
        open.push_back(other);
      }
    }
    ++count;
  }
  return fragment;
}

/// Drops what is small, or off the table for the most part.
void drop_stray_fragments(TableObjects& objects, const PlaneFrame& frame,
                          const ConvexOutline& outline, const TableCropOptions& options) {
  const std::vector<Index> fragment = fragments_of(objects.cloud, options.link);
  struct Size {
    std::size_t points = 0;
    std::size_t inside = 0;
  };
  std::vector<Size> sizes;
  for (Index i = 0; i < objects.cloud.size(); ++i) {
    if (fragment[i] >= sizes.size()) sizes.resize(fragment[i] + std::size_t{1});
    ++sizes[fragment[i]].points;
    const Eigen::Vector3d point = objects.cloud.position(i).cast<double>();
    sizes[fragment[i]].inside += outline.distance(frame.within(point)) < 0.0 ? 1 : 0;
  }
  const auto kept = [&](const Size& size) {
    return size.points >= static_cast<std::size_t>(options.min_fragment) &&
           2 * size.inside >= size.points;
  };
  PointIndices points;
  for (Index i = 0; i < objects.cloud.size(); ++i) {
    if (kept(sizes[fragment[i]])) points.push_back(i);
  }
  objects.dropped_fragments =
      sizes.size() - static_cast<std::size_t>(std::count_if(sizes.begin(), sizes.end(), kept));
  objects.dropped_points = objects.cloud.size() - points.size();
  objects.cloud = select(objects.cloud, points);
}

}  // namespace

void TableCropOptions::validate() const {
  require_option(voxel_size > 0.0, "voxel_size", "a length above 0 m", voxel_size);
  require_option(min_clearance >= 0.0, "min_clearance", "a length not below zero", min_clearance);
  require_option(max_clearance >= min_clearance, "max_clearance", "at least min_clearance",
                 max_clearance);
  require_option(max_height > max_clearance, "max_height", "a length above max_clearance",
                 max_height);
  require_option(overhang >= 0.0, "overhang", "a length not below zero", overhang);
  require_option(link > 0.0, "link", "a length above 0 m", link);
  require_option(min_fragment >= 1, "min_fragment", "at least 1", min_fragment);
}

void TableSceneOptions::validate() const {
  plane.validate();
  crop.validate();
}

TableObjects objects_on(const PointCloud& cloud, const SupportPlane& table,
                        const std::vector<SupportPlane>& walls, const TableCropOptions& options) {
  options.validate();
  PointIndices some;
  for (const Index k : evenly_spread(static_cast<Index>(table.inliers.size()), points_for_bend)) {
    some.push_back(table.inliers[k]);
  }
  const BentPlane surface =
      options.follow_bend ? BentPlane(table.plane, cloud, some) : BentPlane(table.plane);
  const ConvexOutline outline = outline_of(table, surface.frame());
  TableObjects objects;
  objects.clearance = std::clamp(residuals_cleared * surface.residual(cloud, some),
                                 options.min_clearance, options.max_clearance);
  objects.cloud = voxel_downsample(
      points_over(cloud, surface, outline, walls, objects.clearance, options), options.voxel_size);
  drop_stray_fragments(objects, surface.frame(), outline, options);
  return objects;
}

TableScene find_table_scene(const PointCloud& cloud, const TableSceneOptions& options,
                            const std::optional<Eigen::Vector3d>& up) {
  options.validate();
  TableScene scene;
  scene.planes = find_support_planes(cloud, options.plane, up);
  if (scene.planes.status == SupportStatus::none) return scene;
  std::vector<SupportPlane> walls = scene.planes.others;
  walls.insert(walls.end(), scene.planes.supports.begin() + 1, scene.planes.supports.end());
  scene.objects = objects_on(cloud, scene.planes.supports[0], walls, options.crop);
  return scene;
}

TableScene table_scene_on(const PointCloud& cloud, const Plane& table,
                          const TableSceneOptions& options) {
  options.validate();
  TableScene scene;
  scene.planes.supports.push_back(measure_support_plane(cloud, table, options.plane));
  if (scene.planes.supports[0].outline.size() < 3) return scene;
  scene.planes.status = SupportStatus::found;
  scene.objects = objects_on(cloud, scene.planes.supports[0], {}, options.crop);
  return scene;
}

}  // namespace symscene
