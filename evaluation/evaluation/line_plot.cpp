#include "evaluation/line_plot.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "evaluation/markup.hpp"

namespace symscene {
namespace {

/// Where shares are drawn.
class ShareAxes {
 public:
  explicit ShareAxes(std::span<const ShareSeries> series) {
    double least = 1.0;
    for (const ShareSeries& each : series) {
      count_ = std::max(count_, each.values.size());
      for (const double low : each.low) least = std::min(least, low);
    }
    floor_ = std::clamp(0.1 * std::floor(10.0 * least), 0.0, 0.9);
  }

  std::string point(std::size_t k, double share) const {
    return fmt::format("{:.1f},{:.1f}", x(k), y(share));
  }

  std::string grid(const std::string& counted) const {
    std::string svg;
    const int step = floor_ > 0.45 ? 10 : 20;
    for (int percent = 100; percent >= std::lround(100.0 * floor_); percent -= step)
      svg += line_of(percent);
    for (std::size_t k = 0; k < count_; ++k)
      svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", x(k),
                         plot_top + plot_height + 16.0, k + 1);
    return svg + fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                             plot_left + 0.5 * plot_width, plot_top + plot_height + 33.0,
                             escape_markup(counted));
  }

  static std::string view_box() {
    return fmt::format("0 0 {:.0f} {:.0f}", plot_left + plot_width + 14.0,
                       plot_top + plot_height + 40.0);
  }

 private:
  static constexpr double plot_left = 44.0, plot_top = 12.0, plot_width = 328.0,
                          plot_height = 240.0;

  double x(std::size_t k) const {
    const double steps = static_cast<double>(std::max<std::size_t>(2, count_) - 1);
    return plot_left + plot_width * static_cast<double>(k) / steps;
  }
  double y(double share) const { return plot_top + plot_height * (1.0 - share) / (1.0 - floor_); }
  std::string line_of(int percent) const {
    const double height = y(0.01 * percent);
    return fmt::format(
        "<path class=\"grid\" d=\"M{:.1f} {:.1f}h{:.1f}\"/>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{} %</text>\n",
        plot_left, height, plot_width, plot_left - 6.0, height + 4.0, percent);
  }

  std::size_t count_ = 0;
  double floor_ = 0.0;
};

std::string band_of(const ShareAxes& axes, const ShareSeries& series) {
  std::string corners;
  for (std::size_t k = 0; k < series.high.size(); ++k)
    corners += axes.point(k, series.high[k]) + " ";
  for (std::size_t k = series.low.size(); k-- > 0;) corners += axes.point(k, series.low[k]) + " ";
  return fmt::format("<polygon class=\"band c{}\" points=\"{}\"/>\n", series.color, corners);
}

std::string line_of(const ShareAxes& axes, const ShareSeries& series) {
  std::string points;
  for (std::size_t k = 0; k < series.values.size(); ++k)
    points += axes.point(k, series.values[k]) + " ";
  return fmt::format("<polyline class=\"curve c{}\" points=\"{}\"/>\n", series.color, points);
}

}  // namespace

std::string share_figure(const std::string& caption, const std::string& counted,
                         std::span<const ShareSeries> series) {
  const ShareAxes axes(series);
  const std::string title = escape_markup(caption);
  std::string html = fmt::format(
      "<figure>\n<figcaption>{0}</figcaption>\n<svg viewBox=\"{1}\" role=\"img\" "
      "aria-label=\"{0}\" xmlns=\"http://www.w3.org/2000/svg\">\n",
      title, ShareAxes::view_box());
  html += axes.grid(counted);
  for (const ShareSeries& each : series) html += band_of(axes, each);
  for (const ShareSeries& each : series) html += line_of(axes, each);
  html += "</svg>\n<ul class=\"legend\">\n";
  for (const ShareSeries& each : series)
    html += fmt::format("<li><span class=\"swatch c{}\"></span>{}<small>{}</small></li>\n",
                        each.color, escape_markup(each.name), escape_markup(each.note));
  return html + "</ul>\n</figure>\n";
}

}  // namespace symscene
