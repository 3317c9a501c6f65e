#pragma once

#include <vector>

#include "symscene/symmetry/symmetry_group.hpp"

namespace symscene {

/// The orders of the axes of a group, in its order.
inline std::vector<int> orders_of(const SymmetryGroup& group) {
  std::vector<int> orders;
  for (const GroupAxis& found : group.axes) orders.push_back(found.order);
  return orders;
}

}  // namespace symscene
