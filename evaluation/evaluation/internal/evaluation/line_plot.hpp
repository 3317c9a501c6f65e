#pragma once

#include <span>
#include <string>
#include <vector>

namespace symscene {

/// A share over 1, 2, 3 ..., with the interval of each value.
struct ShareSeries {
  std::string name;
  std::size_t color = 0;  ///< less than report_colors
  std::vector<double> values, low, high;
  std::string note;  ///< in the legend
};

/// Shares in percent over 1, 2, 3 ... as an HTML figure of a report: an SVG with a legend below.
/// Lines are values, bands their intervals. The axis of shares begins at a multiple of 10 % below
/// all of them. All series have as many values, at least one.
std::string share_figure(const std::string& caption, const std::string& counted,
                         std::span<const ShareSeries> series);

}  // namespace symscene
