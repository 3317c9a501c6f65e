#include "table_search.hpp"

#include "support_plane.hpp"
#include "symscene/core/error.hpp"
#include "table_objects.hpp"

namespace symscene {

namespace {

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

}  // namespace

void TableCropOptions::validate() const {
  check_fields(*this);
  require_option(max_clearance >= min_clearance, "max_clearance", "at least min_clearance",
                 max_clearance);
  require_option(max_height > max_clearance, "max_height", "more than max_clearance", max_height);
}

TableScene find_table_scene(const PointCloud& cloud, const TableSceneOptions& options,
                            const TablePrior& known) {
  options.validate();
  if (known.plane) return table_scene_on(cloud, *known.plane, options);
  TableScene scene;
  scene.planes = find_support_planes(cloud, options.plane, known);
  if (scene.planes.status == SupportStatus::none) return scene;
  std::vector<SupportPlane> walls = scene.planes.others;
  walls.insert(walls.end(), scene.planes.supports.begin() + 1, scene.planes.supports.end());
  std::erase_if(walls,
                [&](const SupportPlane& plane) { return plane.area < options.plane.wall_area; });
  scene.objects = objects_on(cloud, scene.planes.supports[0], walls, options.crop);
  return scene;
}

}  // namespace symscene
