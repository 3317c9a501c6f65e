#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "symscene/segmentation/graph_cut.hpp"

namespace symscene {

/// The affinities of a node to both labels (Eqs. 4.4, 4.5): the label "background" costs `object`,
/// the label "object" costs `background`.
struct Affinity {
  float object = 0.0F;
  float background = 0.0F;
};

struct GraphCut {
  std::vector<std::uint8_t> is_object;  ///< one per node
  double flow = 0.0;                    ///< the maximum flow, equal to the minimum of Eq. 4.1
};

/// The labelling that minimises Eq. 4.1: a minimum cut, found as a maximum flow. Of all minimal
/// labellings the one with the fewest object nodes: a node is object only if the evidence of some
/// object node reaches it.
///
/// The search is that of Boykov and Kolmogorov (2004) with one tree, which grows only from nodes
/// with evidence for the object, so that its cost depends on the neighbourhood of the object and
/// not on the size of the scene. Capacities are fixed point (1/65536), so that flow and energy are
/// exact. `edges` may repeat a pair (weights add up); weights and affinities are finite, not
/// negative and below 2^13. Throws InputError if an edge names a missing node or a weight is out of
/// range.
GraphCut cut_graph(std::span<const Affinity> nodes, std::span<const WeightedEdge> edges);

/// Eq. 4.1 of any labelling, to the precision of cut_graph.
double labeling_energy(std::span<const Affinity> nodes, std::span<const WeightedEdge> edges,
                       std::span<const std::uint8_t> is_object);

}  // namespace symscene
