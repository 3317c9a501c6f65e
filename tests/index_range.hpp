#pragma once

#include <numeric>

#include "symscene/core/types.hpp"

namespace symscene::testing {

/// The indices from `begin` up to `end`, without `end`.
inline PointIndices index_range(Index begin, Index end) {
  PointIndices indices(end - begin);
  std::iota(indices.begin(), indices.end(), begin);
  return indices;
}

}  // namespace symscene::testing
