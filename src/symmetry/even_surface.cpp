#include <cmath>
#include <string>

#include "core/surface_sampling.hpp"
#include "core/voxel_sampling.hpp"
#include "object_normals.hpp"
#include "symmetry/greatest_distance.hpp"
#include "symscene/core/error.hpp"
#include "symscene/symmetry/symmetry_group.hpp"

namespace symscene {

PointCloud even_surface(const PointCloud& cloud) {
  constexpr double spacing = 0.008;  // share of the diameter
  const PointCloud finite = select(cloud, finite_points(cloud.positions));
  const double diameter = greatest_distance(finite.positions);
  if (!(diameter > 0.0) || !std::isfinite(diameter))
    throw InputError("object", "points that span a finite extent",
                     std::to_string(cloud.size()) + " points that do not");
  PointCloud even = voxel_downsample(finite, spacing * diameter);
  const Eigen::Vector3f center = centroid(even.positions).cast<float>();
  return oriented_surface(std::move(even), center);
}

PointCloud even_surface(const TriangleMesh& mesh) {
  constexpr std::size_t count = 20000;
  return sample_surface(mesh, count);
}

}  // namespace symscene
