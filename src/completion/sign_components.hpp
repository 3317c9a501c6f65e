#pragma once

#include <vector>

#include "node_grid.hpp"

namespace symscene {

/// Turns pieces of the inside, where the field is negative, with less than `min_share` of the nodes
/// of the largest one to the outside.
void remove_small_pieces(const NodeGrid& grid, double min_share, std::vector<float>& field);

/// Turns nodes outside that no path of nodes outside connects with the border to the inside. Border
/// nodes are outside.
void fill_pockets(const NodeGrid& grid, std::vector<float>& field);

}  // namespace symscene
