#include "curve_plot.hpp"

#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "evaluation/markup.hpp"
#include "evaluation/report_text.hpp"
#include "sweep_settings.hpp"

namespace symscene {
namespace {

constexpr double left = 52.0;
constexpr double top = 12.0;
constexpr double side = 320.0;

double x_of(double recall) { return left + side * recall; }
double y_of(double precision) { return top + side * (1.0 - precision); }

CurvePoint point_of(const DetectionCounts& counts) { return {counts.recall(), counts.precision()}; }

std::string at(const CurvePoint& point) {
  return fmt::format("{:.1f},{:.1f}", x_of(point.recall), y_of(point.precision));
}

std::string grid() {
  std::string svg;
  for (int k = 0; k <= 5; ++k) {
    const double share = 0.2 * k;
    svg += fmt::format(
        "<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}M{:.1f} {:.1f}H{:.1f}\"/>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n",
        x_of(share), y_of(0.0), y_of(1.0), x_of(0.0), y_of(share), x_of(1.0), x_of(share),
        y_of(0.0) + 16.0, 20 * k, x_of(0.0) - 6.0, y_of(share) + 4.0, 20 * k);
  }
  svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">recall, %</text>",
                     x_of(0.5), y_of(0.0) + 33.0);
  svg += fmt::format(
      "<text x=\"14\" y=\"{0:.1f}\" text-anchor=\"middle\" transform=\"rotate(-90 14 {0:.1f})\">"
      "precision, %</text>\n",
      y_of(0.5));
  return svg;
}

/// The points of equal F: p = F r / (2 r − F).
std::string equal_f(double f) {
  constexpr int steps = 80;
  std::string path;
  const double first = f / (2.0 - f);  // where precision is 1
  for (int k = 0; k <= steps; ++k) {
    const double recall = first + (1.0 - first) * k / steps;
    path += fmt::format("{}{}", k == 0 ? "M" : "L", at({recall, f * recall / (2.0 * recall - f)}));
  }
  return fmt::format("<path class=\"equal\" d=\"{}\"/>\n", path);
}

std::string star(const CurvePoint& centre, std::size_t color) {
  std::string corners;
  for (int k = 0; k < 10; ++k) {
    const double radius = k % 2 == 0 ? 9.0 : 3.8;
    const double turn = std::numbers::pi * (0.2 * k - 0.5);
    corners += fmt::format("{}{:.1f},{:.1f}", k == 0 ? "" : " ",
                           x_of(centre.recall) + radius * std::cos(turn),
                           y_of(centre.precision) + radius * std::sin(turn));
  }
  return fmt::format("<polygon class=\"star c{}\" points=\"{}\"/>\n", color, corners);
}

/// One dot per place: settings may coincide.
std::string dots(const Sweep& sweep, Metric metric, std::size_t color) {
  std::set<std::string> places;
  for (const SettingCounts& counts : sweep.counts)
    places.insert(fmt::format("M{}h0", at(point_of(counts.detections(metric)))));
  std::string path;
  for (const std::string& place : places) path += place;
  return fmt::format("<path class=\"dots c{}\" d=\"{}\"/>\n", color, path);
}

std::string envelope(const Sweep& sweep, Metric metric, std::size_t color) {
  std::string points;
  for (const CurvePoint& point : precision_recall_curve(sweep, metric)) {
    if (!points.empty()) points += " ";
    points += at(point);
  }
  return fmt::format("<polyline class=\"curve c{}\" points=\"{}\"/>\n", color, points);
}

std::string series(const Sweep& sweep, Metric metric, std::size_t color) {
  const auto best = best_setting(sweep, metric);
  if (!best) return "";
  std::string svg = dots(sweep, metric, color) + envelope(sweep, metric, color);
  if (sweep.at_default) {
    const CurvePoint given = point_of(sweep.at_default->detections(metric));
    svg += fmt::format("<circle class=\"ring c{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"6\"/>\n", color,
                       x_of(given.recall), y_of(given.precision));
  }
  return svg + star(point_of(sweep.counts[*best].detections(metric)), color);
}

/// Whether there was nothing to find and nothing was found.
bool is_of_nothing(const Sweep& sweep, std::size_t setting, Metric metric) {
  const DetectionCounts& counts = sweep.counts[setting].detections(metric);
  return counts.found + counts.ground_truth == 0;
}

std::string legend_entry(const Sweep& sweep, Metric metric, std::size_t color) {
  const auto best = best_setting(sweep, metric);
  if (!best || is_of_nothing(sweep, *best, metric)) return "";
  std::string text = fmt::format("<li><span class=\"swatch c{}\"></span>{}: best F <b>{}</b>",
                                 color, escape_markup(sweep.method),
                                 percent(sweep.counts[*best].detections(metric).f_measure()));
  if (sweep.at_default)
    text += fmt::format(", default {}", percent(sweep.at_default->detections(metric).f_measure()));
  return text + fmt::format("<small>{}</small></li>\n", escape_markup(setting_text(sweep, *best)));
}

}  // namespace

std::string curve_figure(const std::string& caption, const std::vector<const Sweep*>& sweeps,
                         const std::vector<std::size_t>& colors, Metric metric) {
  std::string html = fmt::format(
      "<figure>\n<figcaption>{}</figcaption>\n<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" "
      "aria-label=\"{}\" xmlns=\"http://www.w3.org/2000/svg\">\n",
      escape_markup(caption), left + side + 14.0, top + side + 40.0, escape_markup(caption));
  html += grid();
  for (const double f : {0.2, 0.4, 0.6, 0.8}) html += equal_f(f);
  for (std::size_t k = 0; k < sweeps.size(); ++k) html += series(*sweeps[k], metric, colors[k]);
  html += "</svg>\n<ul class=\"legend\">\n";
  for (std::size_t k = 0; k < sweeps.size(); ++k)
    html += legend_entry(*sweeps[k], metric, colors[k]);
  return html + "</ul>\n</figure>\n";
}

}  // namespace symscene
