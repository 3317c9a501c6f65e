#pragma once

#include <cstdint>
#include <vector>

#include "symscene/core/types.hpp"

namespace symscene {

/// The indices of the keys, sorted by key; equal keys stay in their order. Takes linear time.
std::vector<Index> sorted_order(const std::vector<std::uint64_t>& keys);

}  // namespace symscene
