#include "symscene/segmentation/surface_graph.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"

namespace symscene {
namespace {

class EdgeWeight {
 public:
  EdgeWeight(const PointCloud& cloud, const SurfaceGraphOptions& options)
      : cloud_(cloud),
        convex_(static_cast<float>(options.convex_sigma)),
        concave_(static_cast<float>(options.concave_sigma)) {}

  /// Eq. 4.10
  float operator()(Index a, Index b) const {
    const float bend = std::max(0.0F, 1.0F - cloud_.normal(a).dot(cloud_.normal(b)));
    return std::exp(-bend / (bends_outwards(cloud_, a, b) ? convex_ : concave_));
  }

 private:
  const PointCloud& cloud_;
  float convex_;
  float concave_;
};

}  // namespace

std::vector<WeightedEdge> surface_graph(const PointCloud& cloud,
                                        const SurfaceGraphOptions& options) {
  options.validate();
  const EdgeWeight weight(cloud, options);
  const std::vector<std::pair<Index, Index>> pairs =
      nearest_pairs(cloud.positions, static_cast<std::size_t>(options.neighbors),
                    static_cast<float>(options.radius));
  std::vector<WeightedEdge> edges(pairs.size());
  parallel_for_blocks(pairs.size(), 8192, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      edges[e] = {pairs[e].first, pairs[e].second, weight(pairs[e].first, pairs[e].second)};
    }
  });
  return edges;
}

}  // namespace symscene
