#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/random.hpp"

namespace symscene {

/// The value at the nearest rank of a share of ascending values. Of at least one value.
inline double at_share(std::span<const double> ascending, double share) {
  return ascending[static_cast<std::size_t>(
      std::lround(share * static_cast<double>(ascending.size() - 1)))];
}

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// The 95 % interval of a statistic of `count` items by the percentile bootstrap (Efron 1979):
/// `statistic(drawn)` of 2,000 draws of `count` items with replacement, as indices. The seed is
/// fixed. A draw that has no statistic is left out; none if no draw has one, or without items.
template <class Statistic>
std::optional<Interval> bootstrap_interval(std::size_t count, const Statistic& statistic) {
  constexpr int draws = 2000;
  constexpr double tail = 0.025;
  Random random(1);
  std::vector<std::size_t> drawn(count);
  std::vector<double> values;
  for (int k = 0; count > 0 && k < draws; ++k) {
    for (std::size_t& item : drawn) item = random.below(static_cast<std::uint32_t>(count));
    if (const std::optional<double> value = statistic(std::span<const std::size_t>(drawn)))
      values.push_back(*value);
  }
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  return Interval{at_share(values, tail), at_share(values, 1.0 - tail)};
}

}  // namespace symscene
