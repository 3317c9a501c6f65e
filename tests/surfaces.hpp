#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "core/random_clouds.hpp"
#include "core/surface_sampling.hpp"
#include "core/voxel_sampling.hpp"
#include "scaled_options.hpp"
#include "simulation/shapes.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/occupancy/occupancy_grid.hpp"

/// Known surfaces for tests of the stages that work on oriented points.
namespace symscene::testing {

/// A mesh as a cloud at a spacing of 5 mm. [m]
inline PointCloud as_cloud(const TriangleMesh& mesh) {
  return voxel_downsample(sample_surface(mesh, 40000), 0.005);
}

/// A vase 20 cm high about the z axis.
inline PointCloud vase() {
  const std::array<ProfilePoint, 6> profile{ProfilePoint{0.0, 0.0}, {0.04, 0.0}, {0.07, 0.06},
                                            {0.05, 0.13},           {0.03, 0.2}, {0.0, 0.2}};
  return as_cloud(make_revolution(profile, 96, 0.005));
}

/// A closed box that stands on z = 0 about the z axis.
inline PointCloud box(const Eigen::Vector3d& size) { return as_cloud(make_box(size, 0.005)); }

inline PointCloud moved(PointCloud cloud, const Eigen::Isometry3d& motion) {
  for (Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d position = motion * cloud.position(i).cast<double>();
    const Eigen::Vector3d normal = motion.linear() * cloud.normal(i).cast<double>();
    cloud.positions.row(i) = position.cast<float>().transpose();
    cloud.normals.row(i) = normal.cast<float>().transpose();
  }
  return cloud;
}

/// The points whose normal faces `viewpoint`: what one camera sees of a convex object.
inline PointCloud seen_from(const PointCloud& cloud, const Eigen::Vector3f& viewpoint) {
  PointIndices seen;
  for (Index i = 0; i < cloud.size(); ++i) {
    if (cloud.normal(i).dot(viewpoint - cloud.position(i)) > 0.0F) seen.push_back(i);
  }
  return select(cloud, seen);
}

/// The cloud's points and those of another, side by side.
inline PointCloud joined(const PointCloud& a, const PointCloud& b) {
  PointCloud both;
  both.positions.resize(a.positions.rows() + b.positions.rows(), 3);
  both.normals.resize(both.positions.rows(), 3);
  both.positions << a.positions, b.positions;
  both.normals << a.normals, b.normals;
  return both;
}

inline PointIndices all_of(const PointCloud& cloud) {
  PointIndices indices(cloud.size());
  for (Index i = 0; i < cloud.size(); ++i) indices[i] = i;
  return indices;
}

/// A field that contradicts nothing, of a cloud that is scaled by `scale`.
inline DistanceField nothing_known(const PointCloud& cloud, double scale = 1.0) {
  return unknown_distance_field(bounding_box(cloud.positions), static_cast<float>(0.005 * scale),
                                std::nullopt, scaled_lengths(DistanceFieldOptions{}, scale));
}

/// The space around a cloud that is scaled by `scale`, all of it seen empty except for the voxels
/// with points.
inline DistanceField all_seen(const PointCloud& cloud, double scale = 1.0) {
  OccupancyMap nothing_seen;
  nothing_seen.resolution *= scale;
  OccupancyGrid grid = rasterize(
      nothing_seen, bounding_box(cloud.positions).padded(static_cast<float>(0.1 * scale)));
  std::fill(grid.states.begin(), grid.states.end(), VoxelState::free);
  for (Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f voxel = (cloud.position(i) - grid.frame.origin) / grid.frame.resolution;
    const Eigen::Array3i at = voxel.array().cast<int>();
    grid.states[static_cast<std::size_t>(
        (at.z() * grid.frame.size.y() + at.y()) * grid.frame.size.x() + at.x())] =
        VoxelState::occupied;
  }
  return distance_field(grid, std::nullopt, scaled_lengths(DistanceFieldOptions{}, scale));
}

}  // namespace symscene::testing
