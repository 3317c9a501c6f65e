#include "symscene/tabletop/scene_building.hpp"

#include <limits>

#include "core/voxel_sampling.hpp"
#include "fragments.hpp"
#include "symscene/core/error.hpp"
#include "table_search.hpp"
#include "table_warnings.hpp"

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

/// All points, thinned to one per voxel, without stray fragments.
PointCloud whole_cloud(const PointCloud& points, const TableCropOptions& options) {
  const PointCloud thinned = voxel_downsample(points, options.voxel_size);
  return select(thinned, points_in_fragments(thinned.positions, options));
}

OrientedBox box_around_all(const PointCloud& cloud, double margin) {
  OrientedBox box;
  box.min = cloud.positions.cast<double>().colwise().minCoeff().transpose().array() - margin;
  box.max = cloud.positions.cast<double>().colwise().maxCoeff().transpose().array() + margin;
  return box;
}

}  // namespace

BuiltScene build_scene(const PointCloud& points, const OccupancyVolume& occupancy,
                       const TablePrior& known, const SceneBuildingOptions& options) {
  options.validate();
  if (points.empty()) throw InputError("surface", "at least one point", "none");
  BuiltScene built;
  if (!known.absent) {
    built.table = find_table_scene(points, options.table, known);
    built.scene.warnings = table_warnings(built.table);
  }
  const auto& supports = built.table.planes.supports;
  if (!supports.empty()) built.scene.table = supports.front().plane;
  built.scene.cloud =
      built.scene.table ? built.table.objects.cloud : whole_cloud(points, options.table.crop);
  if (built.scene.cloud.empty()) {
    built.region.min.setConstant(std::numeric_limits<double>::infinity());
    built.region.max = -built.region.min;
    return built;
  }
  built.region = built.scene.table ? box_around(built.scene.cloud, *built.scene.table, options)
                                   : box_around_all(built.scene.cloud, options.margin);
  built.scene.occupancy = occupancy.map(built.region);
  return built;
}

TablePrior prior_of(const Trajectory& cameras) {
  TablePrior prior;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const StampedPose& camera : cameras) {
    sum -= camera.T_world_camera.linear().col(1);
    prior.viewpoints.emplace_back(camera.T_world_camera.translation());
  }
  if (!cameras.empty() && sum.norm() >= 0.5 * static_cast<double>(cameras.size()))
    prior.up = sum.normalized();
  return prior;
}

}  // namespace symscene
