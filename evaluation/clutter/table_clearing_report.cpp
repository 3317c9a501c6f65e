#include "symscene/clutter/table_clearing_report.hpp"

#include <functional>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "symscene/clutter/grasp_trials.hpp"

namespace symscene {
namespace {

constexpr double allowed_penetration = 0.002;  // [m]

/// The share of what is chosen among what is counted, with the tables as rounds.
template <class Count>
RoundShare share_of(std::span<const TableClearing> tables, const Count& count) {
  std::vector<ShareCounts> counts;
  for (const TableClearing& table : tables) counts.push_back(count(table));
  return share_with_interval(counts);
}

/// Counts the items that are `part` among those that are `whole`.
template <class Item, class Whole, class Part>
ShareCounts counted(const std::vector<Item>& items, const Whole& whole, const Part& part) {
  ShareCounts counts;
  for (const Item& item : items) {
    if (whole(item)) counts.add({part(item) ? std::size_t{1} : 0, 1});
  }
  return counts;
}

template <class Whole, class Part>
RoundShare share_of_objects(std::span<const TableClearing> tables, const Whole& whole,
                            const Part& part) {
  return share_of(
      tables, [&](const TableClearing& table) { return counted(table.first_look, whole, part); });
}

template <class Whole, class Part>
RoundShare share_of_attempts(std::span<const TableClearing> tables, const Whole& whole,
                             const Part& part) {
  return share_of(tables,
                  [&](const TableClearing& table) { return counted(table.attempts, whole, part); });
}

bool is_any(const FirstLookObject&) { return true; }
bool is_graspable(const FirstLookObject& object) { return object.graspable; }
bool is_graspable_as_it_lies(const FirstLookObject& object) { return object.graspable_as_it_lies; }
bool has_grasp(const FirstLookObject& object) { return object.grasps > 0; }
bool was_tried_alone(const FirstLookObject& object) { return object.end.has_value(); }
bool has_succeeded_alone(const FirstLookObject& object) { return object.end == GraspEnd::success; }
bool was_tried(const TableAttempt& attempt) { return attempt.tried; }
bool was_tried_first(const TableAttempt& attempt) { return attempt.tried && attempt.number == 1; }
bool has_succeeded(const TableAttempt& attempt) { return attempt.succeeded(); }

RoundShare share_of_removed(std::span<const TableClearing> tables) {
  return share_of(tables, [](const TableClearing& table) {
    if (table.stopped) return ShareCounts{};
    return ShareCounts{static_cast<std::size_t>(table.removed),
                       static_cast<std::size_t>(table.placed)};
  });
}

RoundShare share_of_removed_graspable(std::span<const TableClearing> tables) {
  return share_of(tables, [](const TableClearing& table) {
    if (table.stopped) return ShareCounts{};
    ShareCounts counts = counted(table.first_look, is_graspable, is_any);
    counts.part = static_cast<std::size_t>(table.removed_graspable);
    return counts;
  });
}

RoundShare share_of_cleared(std::span<const TableClearing> tables) {
  return share_of(tables, [](const TableClearing& table) {
    if (table.stopped) return ShareCounts{};
    const bool is_cleared = table.left.empty() && table.end == RoundEnd::cleared;
    return ShareCounts{is_cleared ? std::size_t{1} : 0, 1};
  });
}

void append_figure(std::string& text, const char* name, const RoundShare& share) {
  fmt::format_to(std::back_inserter(text), "{:<62} {}\n", name, share.text());
}

/// How often each label occurs.
using LabelCounts = std::map<std::string, std::size_t>;

void append_counts(std::string& text, const char* title, const LabelCounts& counts) {
  fmt::format_to(std::back_inserter(text), "{}\n", title);
  for (const auto& [label, count] : counts)
    fmt::format_to(std::back_inserter(text), "  {:<60}{:>5}\n", label, count);
}

template <class Selected>
LabelCounts reasons_of(std::span<const TableClearing> tables, const Selected& selected) {
  LabelCounts counts;
  for (const TableClearing& table : tables) {
    for (const FirstLookObject& object : table.first_look) {
      if (!has_grasp(object) && selected(object)) ++counts[object.reason];
    }
  }
  return counts;
}

LabelCounts outcomes_of(std::span<const TableClearing> tables) {
  LabelCounts counts;
  for (const TableClearing& table : tables) {
    for (const TableAttempt& attempt : table.attempts) {
      if (attempt.tried) ++counts[outcome_label(attempt.outcome, attempt.touched_other)];
    }
  }
  return counts;
}

LabelCounts ends_of(std::span<const TableClearing> tables) {
  LabelCounts counts;
  for (const TableClearing& table : tables)
    ++counts[table.stopped ? "stopped after its looks" : to_string(table.end)];
  return counts;
}

LabelCounts left_on(std::span<const TableClearing> tables) {
  LabelCounts counts;
  for (const TableClearing& table : tables) {
    for (const std::string& name : table.left) ++counts[name];
  }
  return counts;
}

/// A value of every look.
template <class Value>
std::vector<double> of_looks(std::span<const TableClearing> tables, const Value& value) {
  std::vector<double> values;
  for (const TableClearing& table : tables) {
    for (const TableAttempt& attempt : table.attempts) values.push_back(value(attempt));
  }
  return values;
}

void append_median(std::string& text, const char* name, const char* unit, double scale,
                   const std::vector<double>& values) {
  if (values.empty()) return;
  fmt::format_to(std::back_inserter(text), "{:<62}{:>8.1f} {}, 95 % below {:.1f}\n", name,
                 scale * quantile_of(values, 0.5), unit, scale * quantile_of(values, 0.95));
}

void append_medians(std::string& text, std::span<const TableClearing> tables) {
  const auto of = [&](double TableAttempt::*value) {
    return of_looks(tables, [&](const TableAttempt& attempt) { return attempt.*value; });
  };
  append_median(text, "error of tracked positions, median of looks", "mm", 1e3,
                of(&TableAttempt::drift));
  append_median(text, "frames that were lost, median of looks", "", 1.0,
                of_looks(tables, [](const TableAttempt& attempt) {
                  return static_cast<double>(attempt.frames - attempt.fused);
                }));
  append_median(text, "time of the reconstruction, median of looks", "s", 1.0,
                of(&TableAttempt::reconstruction_seconds));
  append_median(text, "time of the segmentation", "ms", 1e3,
                of(&TableAttempt::segmentation_seconds));
  append_median(text, "time of the grasps", "ms", 1e3, of(&TableAttempt::grasping_seconds));
}

void append_figures(std::string& text, const TableFigures& figures) {
  append_figure(text, "objects that the hand could hold", figures.graspable);
  append_figure(text, "objects with a grasp at the first look", figures.with_grasp);
  append_figure(text, "  of those that the hand could hold", figures.graspable_with_grasp);
  append_figure(text, "  of those that it could hold as they lie", figures.as_they_lie_with_grasp);
  append_figure(text, "success of the best grasp of each object of the first look",
                figures.each_success);
  append_figure(text, "success of the best grasp of the first look", figures.first_success);
  append_figure(text, "success of the best grasp of all looks (GSR)", figures.success);
  append_figure(text, "  of these at most 2 mm in the true table or other objects",
                figures.no_penetration);
  append_figure(text, "objects that were removed (DR)", figures.removed);
  append_figure(text, "  of those that the hand could hold", figures.graspable_removed);
  append_figure(text, "tables that were cleared", figures.cleared);
}

void append_look_row(int table, const TableAttempt& a, std::string& text) {
  const auto out = std::back_inserter(text);
  const Grasp& grasp = a.grasp;
  fmt::format_to(out, "{},{},{},{},{},{},{:.5f},{:.3f},{:.4f},{:.4f},{:d}", table, a.number,
                 a.present, a.found, a.frames, a.fused, a.drift, a.reconstruction_seconds,
                 a.segmentation_seconds, a.grasping_seconds, a.tried);
  const GraspOutcome& o = a.outcome;
  fmt::format_to(out, ",{},{},{:.4f},{:.4f},{:.4f}", a.aimed,
                 a.tried ? to_string(grasp.source) : "", grasp.quality, grasp.opening,
                 a.aimed_distance);
  GraspFeatures::visit_fields(
      grasp.features, [&](const char*, double value) { fmt::format_to(out, ",{:.5g}", value); });
  fmt::format_to(out, ",{:d},{},{},{:d},{:d},{:.4f},{:.4f},{:.4f},{:.4f}\n", a.succeeded(),
                 a.tried ? to_string(o.end) : "", a.tried ? to_string(o.contact) : "",
                 a.touched_other, a.removed_other, o.short_by, o.closed_width, o.width,
                 a.penetration);
}

}  // namespace

TableFigures table_figures(std::span<const TableClearing> tables) {
  return {share_of_objects(tables, is_any, is_graspable),
          share_of_objects(tables, is_any, has_grasp),
          share_of_objects(tables, is_graspable, has_grasp),
          share_of_objects(tables, is_graspable_as_it_lies, has_grasp),
          share_of_objects(tables, was_tried_alone, has_succeeded_alone),
          share_of_attempts(tables, was_tried_first, has_succeeded),
          share_of_attempts(tables, was_tried, has_succeeded),
          share_of_attempts(tables, was_tried,
                            [](const TableAttempt& attempt) {
                              return attempt.penetration <= allowed_penetration;
                            }),
          share_of_removed(tables),
          share_of_removed_graspable(tables),
          share_of_cleared(tables)};
}

std::string format_table_report(std::span<const TableClearing> tables) {
  std::string text = fmt::format("{} tables; 95 % intervals\n", tables.size());
  append_figures(text, table_figures(tables));
  append_counts(text,
                "objects without a grasp at the first look, of those that the hand could hold",
                reasons_of(tables, is_graspable));
  append_counts(text, "the same of the others", reasons_of(tables, std::not_fn(is_graspable)));
  append_counts(text, "attempts by outcome", outcomes_of(tables));
  append_counts(text, "tables by their end", ends_of(tables));
  append_counts(text, "objects that were left", left_on(tables));
  append_medians(text, tables);
  return text;
}

std::string format_looks_csv(std::span<const TableClearing> tables) {
  std::string text =
      "table,look,present,found,frames,fused,tracking_error,reconstruction_seconds,"
      "segmentation_seconds,grasping_seconds,tried,object,source,quality,opening,aimed_distance";
  const GraspFeatures none;
  GraspFeatures::visit_fields(none,
                              [&](const char* name, double) { text += fmt::format(",{}", name); });
  text +=
      ",success,end,contact,touched_other,removed_other,short_by,closed_width,width,penetration\n";
  for (const TableClearing& table : tables) {
    for (const TableAttempt& attempt : table.attempts) append_look_row(table.table, attempt, text);
  }
  return text;
}

std::string format_first_looks_csv(std::span<const TableClearing> tables) {
  std::string text = "table,object,graspable,graspable_as_it_lies,found,grasps,end,reason\n";
  for (const TableClearing& table : tables) {
    for (const FirstLookObject& o : table.first_look)
      fmt::format_to(std::back_inserter(text), "{},{},{:d},{:d},{:d},{},{},\"{}\"\n", table.table,
                     o.name, o.graspable, o.graspable_as_it_lies, o.found, o.grasps,
                     o.end ? to_string(*o.end) : "", o.reason);
  }
  return text;
}

}  // namespace symscene
