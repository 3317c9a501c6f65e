#include "symscene/segmentation/surface_graph.hpp"

#include <algorithm>
#include <cmath>

#include "symscene/core/error.hpp"
#include "symscene/core/parallel.hpp"

namespace symscene {
namespace {

constexpr std::size_t block = 1024;

struct Candidate {
  float squared_distance;
  Index index;
  bool operator<(const Candidate& other) const {
    return std::pair(squared_distance, index) < std::pair(other.squared_distance, other.index);
  }
};

class EdgeWeight {
 public:
  EdgeWeight(const PointCloud& cloud, const SurfaceGraphOptions& options)
      : cloud_(cloud),
        convex_(static_cast<float>(options.convex_sigma)),
        concave_(static_cast<float>(options.concave_sigma)) {}

  /// Eq. 4.10
  float operator()(Index a, Index b) const {
    const Eigen::Vector3f n_a = cloud_.normal(a);
    const Eigen::Vector3f n_b = cloud_.normal(b);
    const bool convex = (n_a - n_b).dot(cloud_.position(a) - cloud_.position(b)) > 0.0F;
    return std::exp(-std::max(0.0F, 1.0F - n_a.dot(n_b)) / (convex ? convex_ : concave_));
  }

 private:
  const PointCloud& cloud_;
  float convex_;
  float concave_;
};

}  // namespace

void SurfaceGraphOptions::validate() const {
  require_option(neighbors >= 1, "neighbors", "at least 1 point", neighbors);
  require_option(radius > 0.0, "radius", "a length above 0 m", radius);
  require_option(convex_sigma > 0.0, "convex_sigma", "a number above 0", convex_sigma);
  require_option(concave_sigma > 0.0, "concave_sigma", "a number above 0", concave_sigma);
}

std::vector<WeightedEdge> surface_graph(const PointCloud& cloud,
                                        const SurfaceGraphOptions& options) {
  options.validate();
  const auto radius = static_cast<float>(options.radius);
  const CellList cells(cloud.positions, radius);
  const EdgeWeight weight(cloud, options);
  const std::size_t count = cloud.size();
  std::vector<std::vector<std::pair<Index, Index>>> blocks((count + block - 1) / block);
  parallel_for_blocks(count, block, [&](std::size_t begin, std::size_t end) {
    std::vector<Candidate> near;
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      near.clear();
      cells.for_each_within(cloud.position(i), radius, [&](Index j, float squared_distance) {
        if (j != i) near.push_back({squared_distance, j});
      });
      const std::size_t kept = std::min(near.size(), static_cast<std::size_t>(options.neighbors));
      std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(kept), near.end());
      for (std::size_t k = 0; k < kept; ++k)
        blocks[begin / block].push_back(std::minmax(i, near[k].index));
    }
  });
  std::vector<std::pair<Index, Index>> pairs;
  for (const auto& part : blocks) pairs.insert(pairs.end(), part.begin(), part.end());
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

  std::vector<WeightedEdge> edges(pairs.size());
  parallel_for_blocks(pairs.size(), 8192, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      edges[e] = {pairs[e].first, pairs[e].second, weight(pairs[e].first, pairs[e].second)};
    }
  });
  return edges;
}

}  // namespace symscene
