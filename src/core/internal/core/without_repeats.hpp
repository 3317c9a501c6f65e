#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace symscene {

/// The items in their order, without those for which same(item, kept) holds for one kept before.
template <class Item, class Same>
std::vector<Item> without_repeats(std::vector<Item> items, const Same& same) {
  std::vector<Item> kept;
  for (Item& item : items) {
    const bool repeats =
        std::any_of(kept.begin(), kept.end(), [&](const Item& other) { return same(item, other); });
    if (!repeats) kept.push_back(std::move(item));
  }
  return kept;
}

}  // namespace symscene
