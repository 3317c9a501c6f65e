#pragma once

#include "symscene/evaluation/evaluation.hpp"

namespace symscene {

/// Origin of a report.
struct ReportInfo {
  std::string dataset;    ///< name of the dataset
  std::string date;       ///< as text
  std::string version;    ///< of the program
  std::string made_with;  ///< split, options and baselines, in words
};

/// A row of the headline: a method at one setting.
struct HeadlineRow {
  std::string method;
  std::string setting;  ///< "default", or "best of 180"
  std::array<std::optional<double>, all_metrics.size()>
      f;                                      ///< per metric; none where it does not apply
  double mean_overlap = 0.0;                  ///< [IoU]
  SegmentationMetrics points;                 ///< mean over scenes
  std::optional<SegmentationMetrics> pixels;  ///< mean over images, if there are label images
  std::size_t returned = 0;                   ///< number of masks
};

/// "24 scenes, 130 objects", and how many of them are small.
std::string what_was_evaluated(const Evaluation& evaluation);

/// Two rows per method: at the given options, if it has any, and at its best. The second has the
/// greatest F of each metric over all settings, and all else at the best setting for masks at an
/// overlap of 0.9.
std::vector<HeadlineRow> headline(const std::vector<Sweep>& sweeps);

/// Aligned tables for a terminal, in percent.
std::string headline_text(const std::vector<Sweep>& sweeps);
/// Per method with default options: precision, recall and F of masks at 0.9, the best F, and the
/// setting of the best.
std::string default_text(const std::vector<Sweep>& sweeps);
/// The metrics of pixels by method, at the default and the best setting; empty without label
/// images.
std::string pixel_text(const std::vector<Sweep>& sweeps);
std::string missed_object_text(const Evaluation& evaluation);
std::string runtime_text(const Evaluation& evaluation);

/// One line per setting of a method and metric, per object, per scene (docs/formats.md).
std::string curves_csv(const Evaluation& evaluation);
std::string pixels_csv(const Evaluation& evaluation);
std::string objects_csv(const Evaluation& evaluation);
std::string scenes_csv(const Evaluation& evaluation);

/// All numbers of the report (docs/formats.md).
std::string report_json(const Evaluation& evaluation, const ReportInfo& info);

/// A table that compares the headline of a report's JSON with that of an earlier one; numbers that
/// only one of them has are left out. Throws InputError if `earlier` is not a report of
/// version 3 or 4; `name` stands for it in messages.
std::string report_difference(const std::string& report, const std::string& earlier,
                              const std::string& name);

/// The report as one self-contained HTML page without scripts, which is well-formed XML too. Names
/// in it are escaped.
std::string report_page(const Evaluation& evaluation, const ReportInfo& info);

}  // namespace symscene
