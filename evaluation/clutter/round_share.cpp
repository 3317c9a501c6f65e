#include "symscene/clutter/round_share.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/random.hpp"

namespace symscene {

namespace {

/// Sets the interval of Wilson (1927) for independent attempts.
void set_wilson_interval(RoundShare& share) {
  constexpr double z = 1.96;  // two-sided 95 %
  const auto n = static_cast<double>(share.whole);
  const double middle = share.value + z * z / (2.0 * n);
  const double half = z * std::sqrt((share.value * (1.0 - share.value) + z * z / (4.0 * n)) / n);
  const double scale = 1.0 + z * z / n;
  share.low = std::max((middle - half) / scale, 0.0);
  share.high = std::min((middle + half) / scale, 1.0);
}

}  // namespace

std::string RoundShare::text() const {
  if (whole == 0) return "none";
  return fmt::format("{:.1f} % (95 % interval {:.1f} to {:.1f}), {} of {}", 100.0 * value,
                     100.0 * low, 100.0 * high, part, whole);
}

double quantile_of(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(
      std::lround(share * static_cast<double>(values.size() - 1)))];
}

RoundShare share_with_interval(std::span<const ShareCounts> rounds) {
  constexpr int resamples = 2000;
  ShareCounts all;
  for (const ShareCounts& round : rounds) all.add(round);
  RoundShare share{all.share(), 0.0, 1.0, all.part, all.whole};
  if (all.whole == 0) return share;
  Random random(1);
  std::vector<double> shares;
  for (int k = 0; k < resamples; ++k) {
    ShareCounts drawn;
    for (std::size_t i = 0; i < rounds.size(); ++i)
      drawn.add(rounds[random.below(static_cast<std::uint32_t>(rounds.size()))]);
    if (drawn.whole > 0) shares.push_back(drawn.share());
  }
  share.low = quantile_of(shares, 0.025);
  share.high = quantile_of(shares, 0.975);
  if (share.low == share.high) set_wilson_interval(share);
  return share;
}

}  // namespace symscene
