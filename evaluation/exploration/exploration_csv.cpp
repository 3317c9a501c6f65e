#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/number_in.hpp"
#include "symscene/core/error.hpp"
#include "symscene/exploration/exploration_report.hpp"

namespace symscene {
namespace {

constexpr std::string_view csv_header =
    "kind,scene,policy,views,candidate,observed,completed,masks_correct,masks_found,masks_true,"
    "axes_correct,axes_found,axes_true,planes_correct,planes_found,planes_true,grasped,"
    "decision_seconds";
constexpr std::size_t csv_columns = 18;

std::string counts_csv(const DetectionCounts& counts) {
  return fmt::format("{},{},{}", counts.correct, counts.found, counts.ground_truth);
}

/// One line of the file: cells from left to right.
class CsvCells {
 public:
  /// `where` is the place in messages.
  CsvCells(std::string_view line, std::string where) : where_(std::move(where)) {
    if (static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1 != csv_columns)
      throw InputError(where_, fmt::format("{} cells", csv_columns), fmt::format("\"{}\"", line));
    rest_ = line;
  }

  std::string_view text() {
    const std::size_t end = std::min(rest_.find(','), rest_.size());
    const std::string_view cell = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return cell;
  }

  template <class Number>
  Number number() {
    const std::string_view cell = text();
    const auto value = number_in<Number>(cell);
    if (!value) throw InputError(where_, "a number", fmt::format("\"{}\"", cell));
    return *value;
  }

  DetectionCounts counts() {
    DetectionCounts counts;
    counts.correct = number<std::size_t>();
    counts.found = number<std::size_t>();
    counts.ground_truth = number<std::size_t>();
    return counts;
  }

  std::optional<bool> flag() {
    const std::string_view cell = text();
    if (cell.empty()) return std::nullopt;
    if (cell != "0" && cell != "1")
      throw InputError(where_, "1, 0 or nothing", fmt::format("\"{}\"", cell));
    return cell == "1";
  }

 private:
  std::string_view rest_;
  std::string where_;
};

/// Adds a line to the exploration that it continues, or begins another.
void add_line(CsvCells cells, const std::string& where, std::vector<Exploration>& all) {
  const std::string kind(cells.text());
  const int scene = cells.number<int>();
  const ExplorationPolicy policy = parse_exploration_policy(cells.text());
  const auto view = cells.number<std::size_t>();
  if (view == 1) {
    all.push_back({kind, scene, policy, {}});
  } else if (all.empty() || all.back().kind != kind || all.back().scene != scene ||
             all.back().policy != policy || all.back().steps.size() + 1 != view) {
    throw InputError(where, "the next view of the line before", fmt::format("view {}", view));
  }
  ExplorationStep step;
  step.view = cells.number<std::size_t>();
  step.observed = cells.number<double>();
  step.completed = cells.number<double>();
  step.masks = cells.counts();
  step.axes = cells.counts();
  step.planes = cells.counts();
  step.grasped = cells.flag();
  step.decision_seconds = cells.number<double>();
  all.back().steps.push_back(step);
}

}  // namespace

std::string format_explorations_csv(std::span<const Exploration> explorations) {
  std::string csv = fmt::format("{}\n", csv_header);
  for (const Exploration& e : explorations) {
    for (std::size_t k = 0; k < e.steps.size(); ++k) {
      const ExplorationStep& s = e.steps[k];
      csv += fmt::format("{},{},{},{},{},{:.4f},{:.4f},{},{},{},{},{:.4f}\n", e.kind, e.scene,
                         to_string(e.policy), k + 1, s.view, s.observed, s.completed,
                         counts_csv(s.masks), counts_csv(s.axes), counts_csv(s.planes),
                         s.grasped ? (*s.grasped ? "1" : "0") : "", s.decision_seconds);
    }
  }
  return csv;
}

std::vector<Exploration> parse_explorations_csv(std::string_view csv, const std::string& name) {
  std::vector<Exploration> all;
  for (std::size_t number = 1; !csv.empty(); ++number) {
    const std::size_t end = std::min(csv.find('\n'), csv.size());
    const std::string_view line = csv.substr(0, end);
    csv.remove_prefix(std::min(end + 1, csv.size()));
    const std::string where = fmt::format("{}, line {}", name, number);
    if (number > 1) {
      add_line(CsvCells(line, where), where, all);
    } else if (line != csv_header) {
      throw InputError(where, "the header of a table of explorations",
                       fmt::format("\"{}\"", line.substr(0, 80)));
    }
  }
  if (all.empty()) throw InputError(name, "at least one view", "none");
  return all;
}

}  // namespace symscene
