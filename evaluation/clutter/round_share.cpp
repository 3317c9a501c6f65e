#include "symscene/clutter/round_share.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/bootstrap.hpp"

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
  return at_share(values, share);
}

RoundShare share_with_interval(std::span<const ShareCounts> rounds) {
  ShareCounts all;
  for (const ShareCounts& round : rounds) all.add(round);
  RoundShare share{all.share(), 0.0, 1.0, all.part, all.whole};
  if (all.whole == 0) return share;
  const auto share_of = [&](std::span<const std::size_t> drawn) -> std::optional<double> {
    ShareCounts sum;
    for (const std::size_t round : drawn) sum.add(rounds[round]);
    return sum.whole > 0 ? std::optional(sum.share()) : std::nullopt;
  };
  const Interval interval = bootstrap_interval(rounds.size(), share_of).value_or(Interval{});
  share.low = interval.low;
  share.high = interval.high;
  if (share.low == share.high) set_wilson_interval(share);
  return share;
}

}  // namespace symscene
