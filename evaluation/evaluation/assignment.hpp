#pragma once

#include "symscene/evaluation/mask_metrics.hpp"

namespace symscene {

/// A true mask and the found mask assigned to it.
struct MaskPair {
  Index truth = 0;
  Index found = 0;
  double overlap = 0.0;
};

/// The one-to-one pairs of rows and columns with the greatest sum of gains (the Hungarian method,
/// O(n³)), sorted by row. Gains are at least 0; pairs with gain 0 are left out.
std::vector<MaskPair> assign_masks(const OverlapMatrix& gains);

/// The index of the first mask that contains each point; `unlabeled` if none does. If the masks are
/// sorted by descending score, each point gets the highest-scoring mask.
inline constexpr Index unlabeled = ~Index{0};
std::vector<Index> label_points(const std::vector<PointIndices>& masks, std::size_t point_count);

}  // namespace symscene
