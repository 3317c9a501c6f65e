#pragma once

#include <span>
#include <vector>

#include "symscene/segmentation/graph_cut.hpp"

namespace symscene {

/// The summed weight of the edges between object and background, per object node (Eq. 4.13 as
/// used); `edges` carry the λ of the cut.
double smoothness(const std::vector<std::uint8_t>& is_object, std::span<const WeightedEdge> edges);

/// For every node the number of its connected component over the edges between object nodes.
/// Components count from 0 by their lowest node; background nodes have `no_component`.
inline constexpr Index no_component = ~Index{0};
std::vector<Index> connected_components(const std::vector<std::uint8_t>& is_object,
                                        std::span<const WeightedEdge> edges);

/// Makes background of components below a share of the largest one: they agree with a symmetry by
/// chance.
void drop_small_components(std::vector<std::uint8_t>& is_object,
                           const std::vector<WeightedEdge>& edges, double min_share);

/// The nodes labelled object, ascending.
PointIndices object_nodes(const std::vector<std::uint8_t>& is_object);

}  // namespace symscene
