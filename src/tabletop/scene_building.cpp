#include "symscene/tabletop/scene_building.hpp"

#include "symscene/core/error.hpp"
#include "table_search.hpp"

namespace symscene {
namespace {

/// The box around the objects with the table's normal as z axis, from below the table's plane.
OrientedBox box_around(const PointCloud& objects, const Plane& table,
                       const SceneBuildingOptions& options) {
  OrientedBox box;
  Eigen::Matrix3d R;
  R << orthonormal_complement(table.normal), table.normal;
  if (R.determinant() < 0.0) R.col(0) = -R.col(0);
  box.T_world_box.linear() = R;
  const Eigen::Matrix<double, Eigen::Dynamic, 3> inside = objects.positions.cast<double>() * R;
  box.min = inside.colwise().minCoeff().transpose().array() - options.margin;
  box.max = inside.colwise().maxCoeff().transpose().array() + options.margin;
  box.min.z() = -table.offset - options.table_thickness;
  return box;
}

}  // namespace

BuiltScene build_scene(const TriangleMesh& surface, const OccupancyVolume& occupancy,
                       const std::optional<Plane>& plane, const std::optional<Eigen::Vector3d>& up,
                       const SceneBuildingOptions& options) {
  options.validate();
  if (surface.vertices.rows() == 0) throw InputError("surface", "at least one vertex", "none");
  const PointCloud points{surface.vertices, surface.normals, surface.colors};
  BuiltScene built;
  built.table = plane ? table_scene_on(points, *plane, options.table)
                      : find_table_scene(points, options.table, up);
  if (built.table.planes.supports.empty()) return built;
  built.scene.table = built.table.planes.supports.front().plane;
  built.scene.cloud = built.table.objects.cloud;
  if (built.scene.cloud.empty()) return built;
  const OrientedBox region = box_around(built.scene.cloud, *built.scene.table, options);
  built.scene.occupancy = occupancy.map(region);
  built.log_odds = occupancy.log_odds(region);
  return built;
}

std::optional<Eigen::Vector3d> upward(const Trajectory& cameras) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const StampedPose& camera : cameras) sum -= camera.T_world_camera.linear().col(1);
  if (cameras.empty() || sum.norm() < 0.5 * static_cast<double>(cameras.size())) return {};
  return sum.normalized();
}

}  // namespace symscene
