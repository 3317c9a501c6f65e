#include "table_search.hpp"

#include <algorithm>

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

/// The given table, with its normal to the side from which it was seen: that of the cameras, or of
/// its points' normals where no camera is known.
SupportPlane given_table(const PointCloud& searched, const TablePrior& known,
                         const TableSceneOptions& options) {
  SupportPlane table = measure_support_plane(searched, *known.plane, options.plane);
  const Plane reverse{-table.plane.normal, -table.plane.offset};
  SupportPlane reversed = measure_support_plane(searched, reverse, options.plane);
  double height = 0.0;
  for (const Eigen::Vector3d& viewpoint : known.viewpoints)
    height += table.plane.signed_distance(viewpoint);
  const bool is_seen_from_behind =
      known.viewpoints.empty() ? reversed.inliers.size() > table.inliers.size() : height < 0.0;
  return is_seen_from_behind ? reversed : table;
}

TableScene table_scene_on(const PointCloud& cloud, const PointCloud& searched,
                          const TablePrior& known, const TableSceneOptions& options) {
  TableScene scene;
  scene.planes.supports.push_back(given_table(searched, known, options));
  SupportPlane& table = scene.planes.supports.front();
  extend_outline_below_objects(table, searched, options);
  if (table.outline.size() < 3) {
    throw InputError("--plane", "a plane with points on it",
                     fmt::format("none within {} m of {}", options.plane.inlier_distance,
                                 plane_text(*known.plane)));
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
  if (found.objects.cloud.empty()) return large.area > small.area;
  return large.area > much_larger * small.area && large.score > much_better * small.score;
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
