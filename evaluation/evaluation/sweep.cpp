#include "symscene/evaluation/sweep.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "sweep_settings.hpp"
#include "symscene/core/error.hpp"

namespace symscene {

std::string metric_name(Metric metric) {
  static constexpr std::array names = {"masks_90", "masks_75",  "masks_50",   "axes",
                                       "planes",   "axes_near", "planes_near"};
  static_assert(names.size() == all_metrics.size());
  return names[static_cast<std::size_t>(metric)];
}

double SettingCounts::mean_overlap() const {
  const std::size_t objects = detections(Metric::masks_90).ground_truth;
  return objects == 0 ? 1.0 : overlap_sum / static_cast<double>(objects);
}

SettingCounts& SettingCounts::operator+=(const SettingCounts& other) {
  for (std::size_t m = 0; m < counts.size(); ++m) counts[m] += other.counts[m];
  overlap_sum += other.overlap_sum;
  points += other.points;
  scenes += other.scenes;
  pixels += other.pixels;
  images += other.images;
  return *this;
}

bool Sweep::has(Metric metric) const {
  if (std::find(metrics.begin(), metrics.end(), metric) == metrics.end()) return false;
  const auto has_elements = [&](const SettingCounts& setting) {
    return setting.detections(metric).found + setting.detections(metric).ground_truth > 0;
  };
  return std::any_of(counts.begin(), counts.end(), has_elements) ||
         (at_default && has_elements(*at_default));
}

Sweep& Sweep::operator+=(const Sweep& other) {
  if (counts.empty() && !at_default) return *this = other;
  if (other.method != method || other.settings != settings) {
    throw InputError("sweep of " + other.method, "the settings of " + method + " in every scene",
                     std::to_string(other.settings.size()) + " that differ");
  }
  for (std::size_t k = 0; k < counts.size(); ++k) counts[k] += other.counts[k];
  if (at_default && other.at_default) *at_default += *other.at_default;
  seconds += other.seconds;
  return *this;
}

std::optional<std::size_t> best_setting(const Sweep& sweep, Metric metric) {
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < sweep.counts.size(); ++k) {
    const double f = sweep.counts[k].detections(metric).f_measure();
    if (!best || f > sweep.counts[*best].detections(metric).f_measure()) best = k;
  }
  return best;
}

std::vector<CurvePoint> precision_recall_curve(const Sweep& sweep, Metric metric) {
  std::vector<CurvePoint> points;
  for (const SettingCounts& counts : sweep.counts)
    points.push_back({counts.detections(metric).recall(), counts.detections(metric).precision()});
  std::sort(points.begin(), points.end(), [](const CurvePoint& a, const CurvePoint& b) {
    return a.recall != b.recall ? a.recall > b.recall : a.precision > b.precision;
  });
  std::vector<CurvePoint> envelope;
  for (const CurvePoint& point : points) {
    if (envelope.empty() || point.precision > envelope.back().precision) envelope.push_back(point);
  }
  std::reverse(envelope.begin(), envelope.end());
  return envelope;
}

std::string setting_text(const Sweep& sweep, std::size_t setting) {
  std::string text;
  for (std::size_t p = 0; p < sweep.parameters.size(); ++p)
    text += fmt::format("{}{}={:.4g}", p == 0 ? "" : " ", sweep.parameters[p],
                        sweep.settings.at(setting).at(p));
  return text;
}

std::vector<std::vector<double>> all_settings(const std::vector<std::vector<double>>& values) {
  std::vector<std::vector<double>> settings(1);
  for (const std::vector<double>& parameter : values) {
    std::vector<std::vector<double>> longer;
    for (const std::vector<double>& setting : settings) {
      for (const double value : parameter) {
        longer.push_back(setting);
        longer.back().push_back(value);
      }
    }
    settings = std::move(longer);
  }
  return settings;
}

}  // namespace symscene
