#include "symscene/baselines/felzenszwalb.hpp"

#include <algorithm>
#include <tuple>

#include "core/disjoint_sets.hpp"
#include "core/evenly_spaced.hpp"
#include "core/parallel.hpp"
#include "graph_segmentation.hpp"
#include "oriented_input.hpp"
#include "segmentation/segments_of_labels.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

void sort_edges(std::vector<DissimilarEdge>& edges) {
  std::sort(edges.begin(), edges.end(), [](const DissimilarEdge& x, const DissimilarEdge& y) {
    return std::tie(x.weight, x.a, x.b) < std::tie(y.weight, y.a, y.b);
  });
}

/// The components of the graph, joined edge by edge.
class Components {
 public:
  Components(std::size_t nodes, double k)
      : sets_(nodes), size_(nodes, 1), bound_(nodes, k), k_(k) {}

  Index of(Index node) { return sets_.leader(node); }

  /// Edges come in rising order of weight, so that a joining edge is the greatest of the spanning
  /// tree of its component.
  void join_if_alike(const DissimilarEdge& edge) {
    const auto weight = double{edge.weight};
    const Index a = of(edge.a), b = of(edge.b);
    if (a == b || weight > bound_[a] || weight > bound_[b]) return;
    const Index joined = join(a, b);
    bound_[joined] = weight + k_ / static_cast<double>(size_[joined]);
  }

  void join_if_small(const DissimilarEdge& edge, Index min_size) {
    const Index a = of(edge.a), b = of(edge.b);
    if (a != b && std::min(size_[a], size_[b]) < min_size) join(a, b);
  }

 private:
  Index join(Index a, Index b) {
    const Index size = size_[a] + size_[b];
    const Index joined = sets_.join(a, b);
    size_[joined] = size;
    return joined;
  }

  DisjointSets sets_;
  std::vector<Index> size_;    ///< at leaders
  std::vector<double> bound_;  ///< Int(C) + k / |C|, at leaders
  double k_;
};

std::vector<Index> segment_sorted(std::size_t nodes, const std::vector<DissimilarEdge>& edges,
                                  double k, int merge_size) {
  Components components(nodes, k);
  for (const DissimilarEdge& edge : edges) components.join_if_alike(edge);
  for (const DissimilarEdge& edge : edges)
    components.join_if_small(edge, static_cast<Index>(merge_size));
  std::vector<Index> labels(nodes);
  for (Index i = 0; i < nodes; ++i) labels[i] = components.of(i);
  return labels;
}

/// Eq. 1 of Karpathy, Miller and Fei-Fei, with convexity tested from both ends.
float dissimilarity(const PointCloud& cloud, Index a, Index b) {
  const float bend = std::max(0.0F, 1.0F - cloud.normal(a).dot(cloud.normal(b)));
  return bends_outwards(cloud, a, b) ? bend * bend : bend;
}

std::vector<DissimilarEdge> sorted_graph(const PointCloud& cloud,
                                         const FelzenszwalbOptions& options) {
  require_oriented(cloud);
  std::vector<DissimilarEdge> edges;
  for (const auto& [a, b] :
       nearest_pairs(cloud.positions, static_cast<std::size_t>(options.neighbors),
                     static_cast<float>(options.radius)))
    edges.push_back({a, b, dissimilarity(cloud, a, b)});
  sort_edges(edges);
  return edges;
}

}  // namespace

std::vector<Index> segment_graph(std::size_t nodes, std::vector<DissimilarEdge> edges, double k,
                                 int merge_size) {
  sort_edges(edges);
  return segment_sorted(nodes, edges, k, merge_size);
}

std::vector<PointIndices> felzenszwalb_segments(const PointCloud& cloud,
                                                const FelzenszwalbOptions& options) {
  return felzenszwalb_sweep(cloud, options, {options.k}).masks.front();
}

BaselineSweep felzenszwalb_sweep(const PointCloud& cloud, const FelzenszwalbOptions& options,
                                 std::vector<double> ks) {
  if (ks.empty()) ks = evenly_spaced(0.5, 7.0, 0.5);
  FelzenszwalbOptions checked = options;
  for (const double k : ks) {
    checked.k = k;
    checked.validate();
  }
  const std::vector<DissimilarEdge> edges = sorted_graph(cloud, options);
  BaselineSweep sweep{"Felzenszwalb", "k", std::move(ks), {}};
  sweep.masks.resize(sweep.values.size());
  parallel_for_each(sweep.values.size(), [&](std::size_t i) {
    sweep.masks[i] = segments_of_labels(
        segment_sorted(cloud.size(), edges, sweep.values[i], options.merge_size), options.min_size);
  });
  return sweep;
}

}  // namespace symscene
