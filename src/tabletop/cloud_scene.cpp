#include "symscene/tabletop/cloud_scene.hpp"

#include <algorithm>
#include <cmath>

#include "core/voxel_sampling.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// Unit normals that point to the viewpoint.
Points normals_towards(const Points& points, const Eigen::Vector3d& viewpoint,
                       const NormalEstimationOptions& options) {
  const auto undecided = [](const Eigen::Vector3f&, const Eigen::Vector3f&) { return 0.0; };
  Points normals = estimate_normals(points, undecided, options);
  const Eigen::RowVector3f eye = viewpoint.cast<float>().transpose();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (normals.row(i).dot(eye - points.row(i)) < 0.0F) normals.row(i) *= -1.0F;
  }
  return normals;
}

/// The share of the points that satisfy a condition.
template <class Condition>
double share(const PointCloud& cloud, const Condition& condition) {
  Index count = 0;
  for (Index i = 0; i < cloud.size(); ++i) count += condition(i) ? 1 : 0;
  return static_cast<double>(count) / std::max<double>(cloud.size(), 1.0);
}

/// Whether nearly all surfaces face the viewpoint, so that it may be where the sensor was.
bool faces_viewpoint(const PointCloud& cloud, const Eigen::Vector3d& viewpoint) {
  constexpr double nearly_all = 0.95;
  return share(cloud, [&](Index i) {
           return cloud.normal(i).dot(viewpoint.cast<float>() - cloud.position(i)) > 0.0F;
         }) > nearly_all;
}

/// The upward direction in the frame of a sensor that was held upright: −y if it looks along +z, as
/// cameras do, and +z if it looks along +x, as robots do. None if it looks elsewhere.
std::optional<Eigen::Vector3d> sensor_up(const PointCloud& cloud,
                                         const Eigen::Vector3d& viewpoint) {
  constexpr double nearly_all = 0.98;
  const float cosine = std::cos(static_cast<float>(radians(55.0)));
  const auto looks_along = [&](Eigen::Index axis) {
    return share(cloud, [&](Index i) {
             const Eigen::Vector3f ray = cloud.position(i) - viewpoint.cast<float>();
             return ray[axis] > cosine * ray.norm();
           }) > nearly_all;
  };
  if (looks_along(2)) return Eigen::Vector3d(0.0, -1.0, 0.0);
  if (looks_along(0)) return Eigen::Vector3d(0.0, 0.0, 1.0);
  return {};
}

}  // namespace

BuiltScene cloud_scene(const PointCloud& cloud, const Eigen::Vector3d& viewpoint, TablePrior known,
                       const CloudSceneOptions& options) {
  options.validate();
  PointCloud points = voxel_downsample(cloud, options.scene.table.crop.voxel_size);
  if (points.empty()) throw InputError("point cloud", "points with finite coordinates", "none");
  if (oriented_points(points).empty())
    points.normals = normals_towards(points.positions, viewpoint, options.normals);
  points = select(points, oriented_points(points));
  if (points.empty()) throw InputError("point cloud", "points of surfaces", "none");
  if (faces_viewpoint(points, viewpoint)) {
    known.viewpoints = {viewpoint};
    if (!known.up && !known.any_up) known.up = sensor_up(points, viewpoint);
  }
  BuiltScene built = build_scene(points, OccupancyVolume(), known, options.scene);
  // No voxel was observed.
  built.scene.occupancy.reset();
  return built;
}

}  // namespace symscene
