#pragma once

#include <vector>

#include "node_grid.hpp"

namespace symscene {

/// Makes one body without holes inside of a field that is negative inside: turns nodes outside that
/// are enclosed by the body to its inside, and those of small pieces, with less than `min_share` of
/// the nodes of the largest, to the outside. Border nodes are outside.
void keep_one_body(const NodeGrid& grid, double min_share, std::vector<float>& field);

}  // namespace symscene
