#pragma once

#include "symscene/evaluation/evaluation.hpp"

namespace symscene {

/// What a report says of itself.
struct ReportInfo {
  std::string dataset;    ///< its name
  std::string date;       ///< as it is to be shown
  std::string version;    ///< of the program
  std::string made_with;  ///< what the dataset and the run were made with, in words
};

/// A line of the headline: a method at one setting.
struct HeadlineRow {
  std::string method;
  std::string setting;                                      ///< "default", or "best of 180"
  std::array<std::optional<double>, all_metrics.size()> f;  ///< nothing where it means nothing
  double mean_overlap = 0.0;                                ///< [IoU]
  SegmentMetrics segments;                                  ///< mean over scenes
  std::size_t returned = 0;                                 ///< masks
};

/// "24 scenes, 130 objects", with those of which too little is seen to count.
std::string what_was_evaluated(const Evaluation& evaluation);

/// Two lines a method, at the given options (where it has any) and at its best. The best line has
/// the greatest F of each metric over all settings, and all else at the setting that is best for
/// masks at an overlap of 0.9.
std::vector<HeadlineRow> headline(const std::vector<Sweep>& sweeps);

/// Tables for a terminal, aligned, in percent.
std::string headline_text(const std::vector<Sweep>& sweeps);
/// A line a method that has a default: how far that is from the best for masks at 0.9, and where
/// the best is.
std::string default_text(const std::vector<Sweep>& sweeps);
std::string missed_object_text(const Evaluation& evaluation);
std::string runtime_text(const Evaluation& evaluation);

/// One line a setting of a method and metric; an object; a scene (docs/formats.md).
std::string curves_csv(const Evaluation& evaluation);
std::string objects_csv(const Evaluation& evaluation);
std::string scenes_csv(const Evaluation& evaluation);

/// All numbers of the report (docs/formats.md).
std::string report_json(const Evaluation& evaluation, const ReportInfo& info);

/// The headline of a report's JSON with that of an earlier one, number by number, as text; numbers
/// that are in one only are left out. Throws InputError if `earlier` is no report, or one of
/// another version; `name` stands for it in messages.
std::string report_difference(const std::string& report, const std::string& earlier,
                              const std::string& name);

/// The report as one self-contained HTML page, well-formed XML too, without scripts. Text in it is
/// shown as text, whatever characters it holds.
std::string report_page(const Evaluation& evaluation, const ReportInfo& info);

}  // namespace symscene
