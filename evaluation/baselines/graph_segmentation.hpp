#pragma once

#include <vector>

#include "symscene/core/types.hpp"

namespace symscene {

/// An undirected edge weighted by the dissimilarity of its ends.
struct DissimilarEdge {
  Index a = 0;
  Index b = 0;
  float weight = 0.0F;
};

/// The label of every node, that of the lowest node of its component: the graph segmentation of
/// Felzenszwalb and Huttenlocher (2004). Two components become one if the least weight between them
/// is at most Int(C) + k / |C| of either, Int(C) being the greatest weight of its minimum spanning
/// tree; then, by the same order of edges, components smaller than `merge_size` join their
/// neighbours. Ties of weight go to the lower nodes.
std::vector<Index> segment_graph(std::size_t nodes, std::vector<DissimilarEdge> edges, double k,
                                 int merge_size);

}  // namespace symscene
