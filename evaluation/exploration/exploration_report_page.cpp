#include <fmt/format.h>

#include "evaluation/line_plot.hpp"
#include "evaluation/markup.hpp"
#include "evaluation/report_parts.hpp"
#include "exploration_tables.hpp"
#include "symscene/exploration/exploration_report.hpp"

namespace symscene {
namespace {

ShareSeries series_of(ExplorationPolicy policy, const PolicyExplorations& explorations,
                      const ExplorationMeasure& measure) {
  ShareSeries series;
  series.name = to_string(policy);
  series.color = static_cast<std::size_t>(policy) % report_colors;
  for (std::size_t k = 0; k < explorations.front()->steps.size(); ++k) {
    const Estimate known = estimate(at_view(explorations, measure, k), explorations.size());
    series.values.push_back(known.value);
    series.low.push_back(known.low);
    series.high.push_back(known.high);
  }
  const Estimate mean = estimate(area(explorations, measure), explorations.size());
  series.note = fmt::format("mean over views {} % ({} to {})", percent(mean.value),
                            percent(mean.low), percent(mean.high));
  return series;
}

std::string measure_figure(const ComparedScenes& scenes, const ExplorationMeasure& measure) {
  std::vector<ShareSeries> series;
  for (const auto& [policy, explorations] : scenes.by_policy)
    series.push_back(series_of(policy, explorations, measure));
  return share_figure(measure.name, "views", series);
}

/// Empty for a header alone.
std::string titled_table(const char* title, const char* text, const TextTable& table,
                         const char* classes) {
  return table.size() > 1 ? report_section(title, text) + report_table(table, classes) : "";
}

std::string figures_of(const ComparedScenes& scenes) {
  std::string html = "<div class=\"figures\">\n";
  for (const ExplorationMeasure& measure : exploration_measures())
    html += measure_figure(scenes, measure);
  return html + "</div>\n";
}

std::string kind_page(const ComparedScenes& scenes, ExplorationPolicy reference) {
  const std::string title = fmt::format("Scenes: {}", escape_markup(scenes.kind));
  const std::string text = fmt::format("{} scenes, each by every policy.", scenes.scenes());
  std::string html = report_section(title.c_str(), text.c_str()) + figures_of(scenes);
  html += titled_table(
      "Paired differences",
      "Areas under the curves, in points of percent and relative to the other policy, with the "
      "interval that holds 95 % of the differences over scenes drawn anew (2,000 draws), the same "
      "scenes for both policies. An interval that does not contain 0 tells policies apart.",
      difference_table(scenes, reference), "l2");
  html += titled_table("Half the views of the arc", "Paired as above.",
                       half_arc_table(scenes, reference), "l1");
  html += titled_table("Grasps",
                       "The best grasp of the object of which the first view shows least, tried "
                       "and undone in physics.",
                       grasp_table(scenes), "l2");
  html += titled_table("Times", "As measured in this run, with whatever else the machine did.",
                       decision_table(scenes), "l1");
  html += report_section("Values by number of views", "In percent; the mean is the area.");
  for (const ExplorationMeasure& measure : exploration_measures())
    html += report_table(measure_table(scenes, measure), "l1") + "<br/>\n";
  return html;
}

}  // namespace

std::string format_exploration_report_page(std::span<const Exploration> explorations,
                                           const std::string& made_with,
                                           ExplorationPolicy reference) {
  std::string html = report_head("Next views – comparison");
  html += fmt::format(
      "<h1>Next views</h1>\n<p>What is known after each view, by the policy that chooses the "
      "views; bands are 95 % intervals over scenes drawn anew. Observed: true surface within 5 mm "
      "of a point that was seen; completed: or of a closed surface. Symmetries are right within "
      "10° and 1 cm. {}</p>\n",
      escape_markup(made_with));
  for (const ComparedScenes& scenes : compared_scenes(explorations))
    html += kind_page(scenes, reference);
  return html + report_end;
}

}  // namespace symscene
