#pragma once

#include <functional>
#include <vector>

#include "symscene/core/types.hpp"

namespace symscene {

/// The positions of items as a matrix with one row each; `position_of` gives a vector of floats.
template <class Item, class Position = std::identity>
Points as_rows(const std::vector<Item>& items, const Position& position_of = {}) {
  Points rows(static_cast<Eigen::Index>(items.size()), 3);
  for (std::size_t i = 0; i < items.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) = position_of(items[i]).transpose();
  return rows;
}

}  // namespace symscene
