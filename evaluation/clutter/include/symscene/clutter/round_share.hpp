#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace symscene {

/// A part of a whole.
struct ShareCounts {
  std::size_t part = 0;
  std::size_t whole = 0;

  /// 0 of nothing.
  double share() const {
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
  }
  void add(const ShareCounts& other) {
    part += other.part;
    whole += other.whole;
  }
};

/// A share with its 95 % interval by resampling whole rounds, as attempts of one round depend on
/// each other. Where all samples have the same share, as when nothing failed, they say nothing
/// about its uncertainty: the interval is then that of Wilson (1927) for independent attempts. If
/// nothing was counted, the interval is 0 to 1.
struct RoundShare {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
  std::size_t part = 0;
  std::size_t whole = 0;

  /// "98.0 % (95 % interval 95.1 to 100.0), 49 of 50", or "none" of nothing.
  std::string text() const;
};

/// The share of all rounds together, from the counts of each.
RoundShare share_with_interval(std::span<const ShareCounts> rounds);

/// The value below which this share of the values lies. Of at least one value.
double quantile_of(std::vector<double> values, double share);

}  // namespace symscene
