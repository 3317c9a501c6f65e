#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "symscene/evaluation/mask_metrics.hpp"
#include "symscene/evaluation/segmentation_metrics.hpp"

namespace symscene {

/// The metrics of a result, each with precision, recall and F.
enum class Metric {
  masks_90,     ///< Eqs. 4.14 to 4.16 with σ_o = 0.9
  masks_75,     ///< the same with 0.75
  masks_50,     ///< the same with 0.5
  axes,         ///< rotational symmetries within 10° and 10 cm (section 3.6.1)
  planes,       ///< reflectional symmetries within 10° and 10 cm
  axes_near,    ///< within 10° and 1 cm, which a grasp needs
  planes_near,  ///< within 10° and 1 cm
};
inline constexpr std::array all_metrics = {Metric::masks_90,   Metric::masks_75, Metric::masks_50,
                                           Metric::axes,       Metric::planes,   Metric::axes_near,
                                           Metric::planes_near};
/// The least overlap of the first three. [IoU]
inline constexpr std::array mask_overlaps = {0.9, 0.75, 0.5};

/// The name in files: "masks_90", and so on.
std::string metric_name(Metric metric);

/// The counts of one setting of a method, in a scene or summed over scenes.
struct SettingCounts {
  std::array<DetectionCounts, all_metrics.size()> counts;  ///< in the order of all_metrics
  double overlap_sum = 0.0;    ///< of the best overlap of each true object [IoU]
  SegmentationMetrics points;  ///< summed over scenes
  std::size_t scenes = 0;
  SegmentationMetrics pixels;  ///< on label images, summed over images
  std::size_t images = 0;      ///< scenes with label images

  const DetectionCounts& detections(Metric metric) const {
    return counts[static_cast<std::size_t>(metric)];
  }
  DetectionCounts& detections(Metric metric) { return counts[static_cast<std::size_t>(metric)]; }
  /// Mean best overlap of the true objects; 1 without any. [IoU]
  double mean_overlap() const;

  SettingCounts& operator+=(const SettingCounts& other);
};

/// A method over the settings of its parameters, in a scene or summed over scenes.
struct Sweep {
  std::string method;
  std::vector<std::string> parameters;
  std::vector<std::vector<double>> settings;  ///< one value per parameter
  std::vector<SettingCounts> counts;          ///< one per setting
  std::optional<SettingCounts> at_default;    ///< with the given options
  std::vector<Metric> metrics;                ///< that apply to the method
  double seconds = 0.0;  ///< wall time of one setting, summed over scenes; 0 if not measured

  /// Whether the metric applies to the method and has any found or true element.
  bool has(Metric metric) const;
  /// Adds the counts of another scene. Throws InputError if its method or settings differ.
  Sweep& operator+=(const Sweep& other);
};

struct CurvePoint {
  double recall = 0.0;
  double precision = 0.0;
};

/// The upper envelope of precision over recall of the settings, by ascending recall and descending
/// precision: no setting dominates a point of the curve.
std::vector<CurvePoint> precision_recall_curve(const Sweep& sweep, Metric metric);

}  // namespace symscene
