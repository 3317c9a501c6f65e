#pragma once

#include "point_field.hpp"

namespace symscene {

/// Turns inside nodes to the outside that are farther than `reach` from all points and lie in
/// layers of one node or columns of a few: thin remains between regions of free space.
void remove_slivers(const NodeGrid& grid, const NearestPoints& nearest, float reach,
                    std::vector<float>& field);

}  // namespace symscene
