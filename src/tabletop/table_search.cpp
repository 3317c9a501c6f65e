#include "table_search.hpp"

#include <algorithm>

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

TableScene table_scene_on(const PointCloud& cloud, const PointCloud& searched, const Plane& table,
                          const TableSceneOptions& options) {
  TableScene scene;
  scene.planes.supports.push_back(measure_support_plane(searched, table, options.plane));
  if (scene.planes.supports[0].outline.size() < 3) return scene;
  scene.planes.status = SupportStatus::found;
  scene.objects = objects_on(cloud, {searched, scene.planes.supports[0], {}}, options);
  return scene;
}

/// The planes other than the table that are too large to be faces of objects.
std::vector<SupportPlane> walls_of(const SupportPlanes& planes, double wall_area) {
  std::vector<SupportPlane> walls = planes.others;
  walls.insert(walls.end(), planes.supports.begin() + 1, planes.supports.end());
  std::erase_if(walls, [&](const SupportPlane& plane) { return plane.area < wall_area; });
  return walls;
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
  if (known.plane) return table_scene_on(cloud, searched, *known.plane, options);
  TableScene scene;
  scene.planes = find_support_planes(searched, options.plane, known);
  if (scene.planes.status == SupportStatus::none) return scene;
  scene.objects = objects_on(
      cloud, {searched, scene.planes.supports[0], walls_of(scene.planes, options.plane.wall_area)},
      options);
  return scene;
}

}  // namespace symscene
