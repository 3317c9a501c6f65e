#include <algorithm>
#include <cmath>
#include <string>

#include "core/voxel_sampling.hpp"
#include "group_search.hpp"
#include "object_normals.hpp"
#include "symscene/core/error.hpp"

namespace symscene {

double greatest_distance(const Points& points) {
  if (points.rows() == 0) return 0.0;
  constexpr int tried_directions = 1000;
  // Only points that are outermost in some direction can be farthest apart.
  std::vector<Index> outermost;
  for (const Eigen::Vector3d& direction : hemisphere(tried_directions)) {
    const Eigen::VectorXf along = points * direction.cast<float>();
    Eigen::Index low = 0, high = 0;
    along.minCoeff(&low);
    along.maxCoeff(&high);
    outermost.insert(outermost.end(), {static_cast<Index>(low), static_cast<Index>(high)});
  }
  std::sort(outermost.begin(), outermost.end());
  outermost.erase(std::unique(outermost.begin(), outermost.end()), outermost.end());
  float squared = 0.0F;
  for (const Index a : outermost) {
    for (const Index b : outermost)
      squared = std::max(squared, (points.row(a) - points.row(b)).squaredNorm());
  }
  return std::sqrt(double{squared});
}

PointCloud even_surface(const PointCloud& cloud) {
  constexpr double spacing = 0.008;  // by the diameter
  const PointCloud finite = select(cloud, finite_points(cloud.positions));
  const double diameter = greatest_distance(finite.positions);
  if (!(diameter > 0.0) || !std::isfinite(diameter))
    throw InputError("object", "points that span a finite extent",
                     std::to_string(cloud.size()) + " points that do not");
  PointCloud even = voxel_downsample(finite, spacing * diameter);
  const Eigen::Vector3f center = centroid(even.positions).cast<float>();
  return oriented_surface(std::move(even), center);
}

}  // namespace symscene
