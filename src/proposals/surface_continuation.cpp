#include "surface_continuation.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "symscene/core/error.hpp"
#include "symscene/proposals/continuation.hpp"

namespace symscene {
namespace {

constexpr Index sample_size = 90;
constexpr float same_plane = 0.006F;   // [m]
constexpr float same_normal = 0.966F;  // cosine of 15°
constexpr float empty = 0.01F;         // [m]
constexpr double min_hidden = 0.8;

}  // namespace

void ContinuationOptions::validate() const {
  require_option(most >= 0 && most <= 1000, "most", "0 to 1000 proposals", most);
  require_option(min_score >= 0.0, "min_score", "a probability of at least 0", min_score);
  require_option(min_continuation >= 0.0, "min_continuation", "a share of at least 0",
                 min_continuation);
  require_option(whole_belief >= 0.0 && whole_belief <= 1.0, "whole_belief",
                 "a probability in [0, 1]", whole_belief);
  require_option(reach >= 0.0, "reach", "a length of at least 0 m", reach);
}

SurfaceSample sample_surface(const PointCloud& cloud, const PointIndices& points) {
  PointIndices chosen;
  for (const Index k : evenly_spread(static_cast<Index>(points.size()), sample_size))
    chosen.push_back(points[k]);
  const PointCloud part = select(cloud, chosen);
  SurfaceSample sample{part.positions, part.normals, {}, 0.0F};
  sample.center = centroid(part.positions).cast<float>();
  sample.radius = std::sqrt(
      (part.positions.rowwise() - sample.center.transpose()).rowwise().squaredNorm().maxCoeff());
  return sample;
}

double continuation(const SurfaceSample& a, const SurfaceSample& b, const DistanceField& field,
                    float reach) {
  if ((a.center - b.center).norm() > a.radius + b.radius + reach) return 0.0;
  std::vector<std::uint8_t> of_a(static_cast<std::size_t>(a.positions.rows()), 0);
  std::vector<std::uint8_t> of_b(static_cast<std::size_t>(b.positions.rows()), 0);
  double pairs = 0.0, hidden = 0.0;
  float nearest = reach * reach;
  for (Eigen::Index i = 0; i < a.positions.rows(); ++i) {
    const Eigen::Vector3f p = a.positions.row(i).transpose(), n = a.normals.row(i).transpose();
    for (Eigen::Index j = 0; j < b.positions.rows(); ++j) {
      const Eigen::Vector3f across = b.positions.row(j).transpose() - p;
      nearest = std::min(nearest, across.squaredNorm());
      const Eigen::Vector3f m = b.normals.row(j).transpose();
      if (n.dot(m) < same_normal || std::abs(n.dot(across)) > same_plane ||
          std::abs(m.dot(across)) > same_plane)
        continue;
      of_a[static_cast<std::size_t>(i)] = of_b[static_cast<std::size_t>(j)] = 1;
      pairs += 1.0;
      // A little below the surface, where noise does not make it empty.
      hidden += field.at(p + 0.5F * across - 0.005F * n) <= empty ? 1.0 : 0.0;
    }
  }
  if (nearest >= reach * reach || pairs == 0.0 || hidden < min_hidden * pairs) return 0.0;
  const auto share = [](const std::vector<std::uint8_t>& matched) {
    return static_cast<double>(std::count(matched.begin(), matched.end(), std::uint8_t{1})) /
           static_cast<double>(matched.size());
  };
  return std::min(share(of_a), share(of_b));
}

}  // namespace symscene
