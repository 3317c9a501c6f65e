#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace symscene {

/// The value below which that share of the values lies, the upper one; none without values.
template <class T>
std::optional<T> quantile(std::vector<T> values, double share) {
  if (values.empty()) return std::nullopt;
  const auto count = static_cast<double>(values.size());
  const std::size_t rank = std::min(values.size() - 1, static_cast<std::size_t>(share * count));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The upper median; none without values.
template <class T>
std::optional<T> median(std::vector<T> values) {
  return quantile(std::move(values), 0.5);
}

}  // namespace symscene
