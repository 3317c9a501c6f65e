#include "symscene/clutter/round_share.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"

namespace symscene {

double quantile_of(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(
      std::lround(share * static_cast<double>(values.size() - 1)))];
}

RoundShare share_with_interval(std::span<const ShareCounts> rounds) {
  constexpr int resamples = 2000;
  ShareCounts all;
  for (const ShareCounts& round : rounds) all.add(round);
  RoundShare share{all.share(), 0.0, 0.0, all.part, all.whole};
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
  return share;
}

}  // namespace symscene
