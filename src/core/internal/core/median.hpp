#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace symscene {

/// The upper median; none without values.
template <class T>
std::optional<T> median(std::vector<T> values) {
  if (values.empty()) return std::nullopt;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace symscene
