#pragma once

#include "report_text.hpp"
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
TextTable worst_scene_table(const Evaluation& evaluation, std::size_t most);

}  // namespace symscene
