#include "symscene/tabletop/cloud_scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include "core/median.hpp"
#include "core/sign_spreading.hpp"
#include "core/voxel_sampling.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/neighbors.hpp"
#include "visibility.hpp"

namespace symscene {
namespace {

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

bool is_inside(const Box& box, const Eigen::Vector3f& point) {
  return (point - box.min).minCoeff() >= 0.0F && (box.max - point).minCoeff() >= 0.0F;
}

/// The normal of the plane of most points if a viewpoint is nearly in that plane, from where no
/// sensor sees it: of a cloud in the frame of its table. It points to the side on which the other
/// points lie.
std::optional<Eigen::Vector3f> normal_of_grazed_plane(const PointCloud& cloud,
                                                      const Eigen::Vector3f& viewpoint) {
  constexpr float grazing = 0.1F;  // cosine of a normal and the ray
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  const double grazed = share(cloud, [&](Index i) {
    const Eigen::Vector3f ray = (viewpoint - cloud.position(i)).stableNormalized();
    const Eigen::Vector3d normal = cloud.normal(i).cast<double>();
    if (std::abs(cloud.normal(i).dot(ray)) > grazing) return false;
    moments += normal * normal.transpose();
    return true;
  });
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(moments);
  constexpr double most = 0.5, same_normal = 0.8;  // shares
  if (grazed < most || eigen.eigenvalues()[2] < same_normal * moments.trace()) return std::nullopt;
  const Eigen::Vector3f normal = eigen.eigenvectors().col(2).cast<float>();
  std::vector<float> heights;
  double mean = 0.0;
  for (Index i = 0; i < cloud.size(); ++i) {
    heights.push_back(normal.dot(cloud.position(i)));
    mean += double{heights.back()} / cloud.size();
  }
  const float middle = median(std::move(heights)).value_or(0.0F);
  return mean < double{middle} ? Eigen::Vector3f(-normal) : normal;
}

/// Where the points of a fused cloud are looked at from. A camera does not stand inside the box of
/// its points, or in the plane of most of them; such a viewpoint is replaced by one high above:
/// over that plane, or along z.
Eigen::Vector3f outer_viewpoint(const PointCloud& cloud, const Eigen::Vector3f& viewpoint) {
  constexpr float diagonals_above = 10.0F;
  const Box box = bounding_box(cloud.positions);
  std::optional<Eigen::Vector3f> up = normal_of_grazed_plane(cloud, viewpoint);
  if (!up && is_inside(box, viewpoint)) up = Eigen::Vector3f::UnitZ();
  if (!up) return viewpoint;
  return 0.5F * (box.min + box.max) + diagonals_above * (box.max - box.min).norm() * *up;
}

void turn_towards(const Eigen::Vector3f& eye, PointCloud& cloud, const PointIndices& points) {
  for (const Index i : points) {
    if (cloud.normal(i).dot(eye - cloud.position(i)) < 0.0F) cloud.normals.row(i) *= -1.0F;
  }
}

/// The points at which the surface faces `eye` clearly or faces away clearly.
PointIndices without_grazing(const PointCloud& cloud, const Eigen::Vector3f& eye,
                             const PointIndices& points) {
  constexpr float min_cosine = 0.3F;
  PointIndices kept;
  for (const Index i : points) {
    const Eigen::Vector3f ray = (eye - cloud.position(i)).stableNormalized();
    if (std::abs(cloud.normal(i).dot(ray)) > min_cosine) kept.push_back(i);
  }
  return kept;
}

std::string sentence_on_normals(const Eigen::Vector3f& eye, bool is_sensor) {
  const std::string how =
      "the cloud has no usable normals: they are estimated from neighbouring points and point to ";
  if (is_sensor)
    return how + fmt::format("the sensor at ({:.2f}, {:.2f}, {:.2f})", eye.x(), eye.y(), eye.z());
  return how + fmt::format("the outside as seen from ({:.2f}, {:.2f}, {:.2f})", eye.x(), eye.y(),
                           eye.z());
}

/// Estimates normals, and says to where they point. All surfaces of a single view face the
/// viewpoint, which sees nearly all points. In a fused cloud those that are seen do, and signs
/// spread from them to the others.
std::string add_normals(PointCloud& cloud, const Eigen::Vector3d& viewpoint,
                        const NormalEstimationOptions& options) {
  constexpr double nearly_all = 0.9;
  // In spacings of the points: a cell for the sensor's view, in which a surface at a slant of 75°
  // spans `slanted_depth`; a cell without gaps between points, through which hidden surfaces would
  // be seen; and less than the thickness of a vessel's wall.
  constexpr float narrow = 2.0F, slanted_depth = 8.0F, wide = 4.0F, thin_wall = 1.5F;
  const Eigen::Vector3f eye = viewpoint.cast<float>();
  const auto towards_eye = [&](const Eigen::Vector3f& position, const Eigen::Vector3f& direction) {
    return double{direction.dot(eye - position)};
  };
  cloud.normals = estimate_normals(cloud.positions, towards_eye, options);
  const Eigen::Vector3f outer = outer_viewpoint(cloud, eye);
  const Visibility from_sensor(cloud.positions, eye, narrow);
  const auto seen = static_cast<double>(from_sensor.seen(cloud.positions, slanted_depth).size());
  if (outer == eye && seen > nearly_all * cloud.size()) {
    turn_towards(eye, cloud, evenly_spread(cloud.size(), cloud.size()));
    return sentence_on_normals(eye, true);
  }
  const Visibility from_outside(cloud.positions, outer, wide);
  const PointIndices known =
      without_grazing(cloud, outer, from_outside.seen(cloud.positions, thin_wall));
  turn_towards(outer, cloud, known);
  std::vector<bool> visited(cloud.size(), false);
  spread_signs(known,
               nearest_neighbors(cloud.positions, static_cast<std::size_t>(options.neighbors)),
               cloud.normals, visited);
  return sentence_on_normals(outer, false);
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
  const bool lacks_normals = oriented_points(points).empty();
  std::string on_normals;
  if (lacks_normals) on_normals = add_normals(points, viewpoint, options.normals);
  points = select(points, oriented_points(points));
  if (points.empty()) throw InputError("point cloud", "points of surfaces", "none");
  if (faces_viewpoint(points, viewpoint)) {
    known.viewpoints = {viewpoint};
    if (!known.up && !known.any_up) known.up = sensor_up(points, viewpoint);
  }
  BuiltScene built = build_scene(points, OccupancyVolume(), known, options.scene);
  // No voxel was observed.
  built.scene.occupancy.reset();
  if (lacks_normals) built.scene.warnings.push_back(on_normals);
  return built;
}

}  // namespace symscene
