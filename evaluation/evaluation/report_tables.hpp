#pragma once

#include "evaluation/report_text.hpp"
#include "symscene/evaluation/report.hpp"

namespace symscene {

/// The tables of the report, for the terminal and the page.
TextTable headline_table(const std::vector<Sweep>& sweeps);
TextTable pixel_table(const std::vector<Sweep>& sweeps);
TextTable default_table(const std::vector<Sweep>& sweeps);
TextTable missed_object_table(const Evaluation& evaluation);
TextTable reason_table(const Evaluation& evaluation);
TextTable kind_table(const Evaluation& evaluation);
TextTable runtime_table(const Evaluation& evaluation);
TextTable method_time_table(const Evaluation& evaluation);
/// The paired differences of paired_differences(); only a header without any.
TextTable paired_table(const Evaluation& evaluation);
/// Without the columns that hold nothing but dashes.
TextTable without_empty_columns(TextTable table);
TextTable worst_scene_table(const Evaluation& evaluation, std::size_t most);

}  // namespace symscene
