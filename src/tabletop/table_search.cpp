#include "table_search.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/plane_text.hpp"
#include "removed_table.hpp"
#include "support_plane.hpp"
#include "symscene/core/error.hpp"
#include "table_objects.hpp"

namespace symscene {
namespace {

/// Planes are searched in at most this many points, evenly spread over the cloud; in a share of a
/// large one, as a table in a room has a share of its points.
Index searched_points(const PointCloud& cloud) {
  constexpr Index least = 60000, most = 240000, interval = 16;
  return std::clamp(cloud.size() / interval, least, most);
}

/// The number of points that stand on a plane.
std::size_t standing_on(const Plane& plane, const PointCloud& cloud,
                        const SupportPlaneOptions& options) {
  std::size_t standing = 0;
  for (Index i = 0; i < cloud.size(); ++i) {
    const double height = plane.signed_distance(cloud.position(i).cast<double>());
    standing += height > options.inlier_distance && height < options.max_height ? 1 : 0;
  }
  return standing;
}

/// The side with more points of its own surface, unless those are undersides of objects: nothing
/// stands there, and more points stand on the other side.
SupportPlane likelier_side(SupportPlane table, SupportPlane reversed, const PointCloud& cloud,
                           const SupportPlaneOptions& options) {
  if (reversed.inliers.size() > table.inliers.size()) std::swap(table, reversed);
  const bool is_underside = standing_on(table.plane, cloud, options) == 0 &&
                            standing_on(reversed.plane, cloud, options) > table.inliers.size();
  return is_underside ? reversed : table;
}

/// The given table, with its normal to the side of the cameras or, where no camera is known, to the
/// likelier side.
SupportPlane given_table(const PointCloud& searched, const TablePrior& known,
                         const TableSceneOptions& options) {
  SupportPlane table = measure_support_plane(searched, *known.plane, options.plane);
  const Plane reverse{-table.plane.normal, -table.plane.offset};
  SupportPlane reversed = measure_support_plane(searched, reverse, options.plane);
  if (known.viewpoints.empty())
    return likelier_side(std::move(table), std::move(reversed), searched, options.plane);
  double height = 0.0;
  for (const Eigen::Vector3d& viewpoint : known.viewpoints)
    height += table.plane.signed_distance(viewpoint);
  return height < 0.0 ? reversed : table;
}

TableScene table_scene_on(const PointCloud& cloud, const PointCloud& searched,
                          const TablePrior& known, const TableSceneOptions& options) {
  TableScene scene;
  scene.planes.supports.push_back(given_table(searched, known, options));
  SupportPlane& table = scene.planes.supports.front();
  extend_outline_below_objects(table, searched, options);
  if (table.outline.size() < 3) {
    throw InputError("--plane", "a plane with points on it",
                     fmt::format("fewer than three within {} m of {}",
                                 options.plane.inlier_distance, plane_text(*known.plane)));
  }
  scene.planes.status = SupportStatus::found;
  scene.objects = objects_on(cloud, {searched, table, {}}, options);
  return scene;
}

/// The planes other than the table that are too large to be faces of objects.
std::vector<SupportPlane> walls_of(const SupportPlanes& planes, double wall_area) {
  std::vector<SupportPlane> walls = planes.others;
  walls.insert(walls.end(), planes.supports.begin() + 1, planes.supports.end());
  std::erase_if(walls, [&](const SupportPlane& plane) { return plane.area < wall_area; });
  return walls;
}

/// The table among the planes of the cloud, and the objects on it.
TableScene searched_table_scene(const PointCloud& cloud, const PointCloud& searched,
                                const TablePrior& known, const TableSceneOptions& options) {
  TableScene scene;
  scene.planes = find_support_planes(searched, options.plane, known);
  if (scene.planes.status == SupportStatus::none) return scene;
  const FoundPlanes found{searched, scene.planes.supports[0],
                          walls_of(scene.planes, options.plane.wall_area)};
  scene.objects = objects_on(cloud, found, options);
  return scene;
}

/// Whether a table may be a face of an object: it is small, or nothing stands on it.
bool may_be_a_face(const TableScene& scene, const TableSceneOptions& options) {
  return scene.objects.cloud.empty() || scene.planes.supports[0].area < options.plane.wall_area;
}

/// Whether `other` carries objects and is so much larger than the table that was found that this is
/// more likely a face of one of them.
bool is_rather_the_table(const TableScene& other, const TableScene& found) {
  constexpr double much_larger = 5.0, much_better = 3.0;
  if (other.objects.cloud.empty()) return false;
  if (found.planes.supports.empty()) return true;
  const SupportPlane &large = other.planes.supports[0], &small = found.planes.supports[0];
  if (large.area <= much_larger * small.area) return false;
  return found.objects.cloud.empty() || large.score > much_better * small.score;
}

}  // namespace

void TableCropOptions::validate() const {
  check_fields(*this);
  require_option(max_clearance >= min_clearance, "max_clearance", "at least min_clearance",
                 max_clearance);
}

void TableSceneOptions::validate() const {
  check_fields(*this);
  require_option(plane.max_height > crop.max_clearance, "plane.max_height",
                 "more than crop.max_clearance", plane.max_height);
}

TableScene find_table_scene(const PointCloud& cloud, const TableSceneOptions& options,
                            const TablePrior& known) {
  options.validate();
  const PointCloud searched = select(cloud, evenly_spread(cloud.size(), searched_points(cloud)));
  if (known.plane) return table_scene_on(cloud, searched, known, options);
  TableScene scene = searched_table_scene(cloud, searched, known, options);
  if (!known.up || !may_be_a_face(scene, options)) return scene;
  TablePrior turned = known;
  turned.up.reset();
  TableScene other = searched_table_scene(cloud, searched, turned, options);
  if (!is_rather_the_table(other, scene)) return scene;
  other.is_against_up = true;
  return other;
}

}  // namespace symscene
