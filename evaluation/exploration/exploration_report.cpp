#include "symscene/exploration/exploration_report.hpp"

#include <fmt/format.h>

#include "exploration_tables.hpp"

namespace symscene {
namespace {

/// Nothing of a table that is a header alone.
std::string table_text(const TextTable& table, std::size_t left) {
  return table.size() > 1 ? aligned(table, left) + "\n" : "";
}

std::string kind_text(const ComparedScenes& scenes, ExplorationPolicy reference) {
  std::string text = fmt::format("{} scenes, {}\n\n", scenes.scenes(), scenes.kind);
  for (const ExplorationMeasure& measure : exploration_measures())
    text += table_text(measure_table(scenes, measure), 1);
  text += table_text(grasp_table(scenes), 2);
  text += table_text(difference_table(scenes, reference), 2);
  text += table_text(half_arc_table(scenes, reference), 1);
  return text + table_text(decision_table(scenes), 1);
}

}  // namespace

std::string format_exploration_report(std::span<const Exploration> explorations,
                                      ExplorationPolicy reference) {
  std::string text;
  for (const ComparedScenes& scenes : compared_scenes(explorations))
    text += kind_text(scenes, reference);
  return text.empty() ? "no scene\n" : text;
}

}  // namespace symscene
