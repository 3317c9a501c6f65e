#pragma once

#include <span>
#include <vector>

#include "symscene/core/types.hpp"

namespace symscene {

/// The label of a point that is in no segment.
inline constexpr Index no_segment = ~Index{0};

/// The points of each label, largest first, ties by the lowest point; labels of fewer than
/// `min_size` points are left out.
std::vector<PointIndices> segments_of_labels(std::span<const Index> labels, int min_size);

}  // namespace symscene
