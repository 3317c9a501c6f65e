#include "surface_continuation.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace symscene {
namespace {

/// The options in single precision, as the points are.
struct Tolerances {
  explicit Tolerances(const ContinuationOptions& options)
      : max_gap(static_cast<float>(options.max_gap)),
        max_plane_offset(static_cast<float>(options.max_plane_offset)),
        min_normal_cosine(static_cast<float>(options.min_normal_cosine)),
        empty_distance(static_cast<float>(options.empty_distance)),
        probe_depth(static_cast<float>(options.probe_depth)) {}

  float max_gap, max_plane_offset, min_normal_cosine, empty_distance, probe_depth;
};

/// The share of points with a flag.
double share(const std::vector<std::uint8_t>& flags) {
  return static_cast<double>(std::count(flags.begin(), flags.end(), std::uint8_t{1})) /
         static_cast<double>(flags.size());
}

}  // namespace

SurfaceSample sample_surface(const PointCloud& cloud, const PointIndices& points,
                             Index max_points) {
  PointIndices chosen;
  for (const Index k : evenly_spread(static_cast<Index>(points.size()), max_points))
    chosen.push_back(points[k]);
  const PointCloud part = select(cloud, chosen);
  SurfaceSample sample{part.positions, part.normals, {}, 0.0F};
  sample.center = centroid(part.positions).cast<float>();
  sample.radius = std::sqrt(
      (part.positions.rowwise() - sample.center.transpose()).rowwise().squaredNorm().maxCoeff());
  return sample;
}

double continuation(const SurfaceSample& a, const SurfaceSample& b, const DistanceField& field,
                    const ContinuationOptions& options) {
  const Tolerances limits(options);
  if ((a.center - b.center).norm() > a.radius + b.radius + limits.max_gap) return 0.0;
  std::vector<std::uint8_t> of_a(static_cast<std::size_t>(a.positions.rows()), 0);
  std::vector<std::uint8_t> of_b(static_cast<std::size_t>(b.positions.rows()), 0);
  double pairs = 0.0, hidden = 0.0;
  float nearest = limits.max_gap * limits.max_gap;
  for (Eigen::Index i = 0; i < a.positions.rows(); ++i) {
    const Eigen::Vector3f p = a.positions.row(i).transpose(), n = a.normals.row(i).transpose();
    for (Eigen::Index j = 0; j < b.positions.rows(); ++j) {
      const Eigen::Vector3f across = b.positions.row(j).transpose() - p;
      nearest = std::min(nearest, across.squaredNorm());
      const Eigen::Vector3f m = b.normals.row(j).transpose();
      if (n.dot(m) < limits.min_normal_cosine ||
          std::abs(n.dot(across)) > limits.max_plane_offset ||
          std::abs(m.dot(across)) > limits.max_plane_offset)
        continue;
      of_a[static_cast<std::size_t>(i)] = of_b[static_cast<std::size_t>(j)] = 1;
      pairs += 1.0;
      // A little below the surface, where noise does not make it empty.
      const Eigen::Vector3f probe = p + 0.5F * across - limits.probe_depth * n;
      hidden += field.at(probe) <= limits.empty_distance ? 1.0 : 0.0;
    }
  }
  if (nearest >= limits.max_gap * limits.max_gap || pairs == 0.0 ||
      hidden < options.min_hidden_share * pairs)
    return 0.0;
  return std::min(share(of_a), share(of_b));
}

}  // namespace symscene
