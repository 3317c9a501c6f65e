#include "symscene/clutter/clutter_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "symscene/clutter/grasp_trials.hpp"

namespace symscene {
namespace {

using Counts = ShareCounts;

Counts counts_of(bool part) { return {part ? std::size_t{1} : 0, 1}; }

bool succeeded(const ClutterAttempt& attempt) { return attempt.outcome.end == GraspEnd::success; }

std::vector<const ClutterAttempt*> all_attempts(std::span<const ClutterRound> rounds) {
  std::vector<const ClutterAttempt*> attempts;
  for (const ClutterRound& round : rounds) {
    for (const ClutterAttempt& attempt : round.attempts) attempts.push_back(&attempt);
  }
  return attempts;
}

/// Lines "LABEL NUMBER SHARE", in the order of the labels.
using Tally = std::map<std::string, Counts>;

void append_tally(std::string& text, const std::string& title, const Tally& tally) {
  text += title + "\n";
  for (const auto& [label, counts] : tally)
    fmt::format_to(std::back_inserter(text), "  {:<52}{:>6} of {:<6}{:>6.1f} %\n", label,
                   counts.part, counts.whole, 100.0 * counts.share());
}

/// How often each label occurs.
template <class Items, class Label>
Tally frequencies(const Items& items, const Label& label) {
  Tally tally;
  for (const auto& item : items) ++tally[label(item)].part;
  for (auto& [name, counts] : tally) counts.whole = items.size();
  return tally;
}

/// The share of successful attempts by label.
Tally successes(const std::vector<const ClutterAttempt*>& attempts,
                const std::function<std::string(const ClutterAttempt&)>& label) {
  Tally tally;
  for (const ClutterAttempt* attempt : attempts)
    tally[label(*attempt)].add(counts_of(succeeded(*attempt)));
  return tally;
}

std::string occlusion_label(const ClutterAttempt& attempt) {
  constexpr std::array bounds{0.0, 0.1, 0.25, 0.5, 0.75, 1.0};
  std::size_t k = 0;
  while (k + 2 < bounds.size() && attempt.occlusion >= bounds[k + 1]) ++k;
  return fmt::format("{:.0f} to {:.0f} % hidden", 100.0 * bounds[k], 100.0 * bounds[k + 1]);
}

std::string quality_label(const ClutterAttempt& attempt) {
  constexpr double width = 0.1;
  const double low = std::min(0.9, width * std::floor(attempt.grasp.quality / width));
  return fmt::format("quality {:.1f} to {:.1f}", low, low + width);
}

std::string end_label(const ClutterAttempt* attempt) {
  return outcome_label(attempt->outcome, attempt->touched_other);
}

std::string penetration_label(const ClutterAttempt* attempt) {
  constexpr double bound = 0.002;  // [m]
  return attempt->penetration > bound ? "deeper than 2 mm" : "up to 2 mm";
}

void append_share(std::string& text, const char* name, const RoundShare& share) {
  fmt::format_to(std::back_inserter(text), "{} {}\n", name, share.text());
}

void append_times(std::string& text, const std::vector<const ClutterAttempt*>& attempts) {
  std::vector<double> seconds, grasping;
  for (const ClutterAttempt* attempt : attempts) {
    seconds.push_back(attempt->seconds);
    grasping.push_back(attempt->grasping_seconds);
  }
  fmt::format_to(
      std::back_inserter(text),
      "planning time: median {:.0f} ms, 95 % below {:.0f} ms; of these for grasps {:.0f} "
      "and {:.0f} ms\n",
      1e3 * quantile_of(seconds, 0.5), 1e3 * quantile_of(seconds, 0.95),
      1e3 * quantile_of(grasping, 0.5), 1e3 * quantile_of(grasping, 0.95));
}

/// The reasons for which objects had no grasp when a round ended for want of one.
Tally missing_grasps(std::span<const ClutterRound> rounds) {
  std::vector<std::string> reasons;
  for (const ClutterRound& round : rounds) {
    if (round.end != RoundEnd::no_grasp) continue;
    reasons.insert(reasons.end(), round.reasons.begin(), round.reasons.end());
    if (!round.reasons.empty()) continue;
    reasons.emplace_back(round.outside > 0 ? "all grasps are outside the grasp volume"
                                           : "no object is seen");
  }
  return frequencies(reasons, [](const std::string& reason) { return reason; });
}

void append_row(const ClutterAttempt& a, bool is_rehearsal, std::string& text) {
  auto out = std::back_inserter(text);
  const Grasp& grasp = a.grasp;
  fmt::format_to(out, "{},{},{:d},{},{},{},{:.3f},{},{:.4f},{:.4f},{:.4f}", a.round, a.number,
                 is_rehearsal, a.aimed, a.present, a.seen, a.occlusion, to_string(grasp.source),
                 grasp.quality, grasp.opening, a.aimed_distance);
  GraspFeatures::visit_fields(
      grasp.features, [&](const char*, double value) { fmt::format_to(out, ",{:.5g}", value); });
  const GraspOutcome& o = a.outcome;
  fmt::format_to(out, ",{:d},{},{},{:d},{:d},{:.4f},{:.4f},{:.4f},{:.4f},{:.3f}\n", succeeded(a),
                 to_string(o.end), to_string(o.contact), a.touched_other, a.removed_other,
                 o.short_by, o.closed_width, o.width, a.penetration, a.seconds);
}

/// Of objects on one side of the occlusion at which half of an object is hidden.
class OcclusionClass {
 public:
  explicit OcclusionClass(bool hidden) : hidden_(hidden) {}

  const char* name() const { return hidden_ ? "half or more hidden" : "less hidden"; }

  Counts attempts(const ClutterRound& round) const {
    Counts counts;
    for (const ClutterAttempt& a : round.attempts) {
      if (holds(a.occlusion)) counts.add(counts_of(succeeded(a)));
    }
    return counts;
  }
  Counts placed(const ClutterRound& round) const {
    Counts counts;
    for (const PlacedItem& object : round.placed_objects) {
      if (holds(object.occlusion)) counts.add(counts_of(object.removed));
    }
    return counts;
  }
  Counts with_grasp(const ClutterRound& round) const {
    Counts counts;
    for (const ObjectTrial& trial : round.trials) {
      if (holds(trial.occlusion)) counts.add(counts_of(trial.succeeded.has_value()));
    }
    return counts;
  }
  Counts best_grasps(const ClutterRound& round) const {
    Counts counts;
    for (const ObjectTrial& trial : round.trials) {
      if (holds(trial.occlusion) && trial.succeeded) counts.add(counts_of(*trial.succeeded));
    }
    return counts;
  }

 private:
  bool holds(double occlusion) const { return (occlusion >= 0.5) == hidden_; }

  bool hidden_;
};

void append_occlusion_classes(std::string& text, std::span<const ClutterRound> rounds) {
  for (const OcclusionClass hidden : {OcclusionClass(true), OcclusionClass(false)}) {
    const auto append = [&](const char* what,
                            Counts (OcclusionClass::*count)(const ClutterRound&) const) {
      std::vector<Counts> counts;
      for (const ClutterRound& round : rounds) counts.push_back((hidden.*count)(round));
      const RoundShare share = share_with_interval(counts);
      if (share.whole > 0) append_share(text, what, share);
    };
    text += fmt::format("objects {}\n", hidden.name());
    append("  grasp success rate", &OcclusionClass::attempts);
    append("  declutter rate, by occlusion at the start", &OcclusionClass::placed);
    append("  objects with a grasp", &OcclusionClass::with_grasp);
    append("  success of their best grasp", &OcclusionClass::best_grasps);
  }
}

}  // namespace

RoundShare grasp_success_rate(std::span<const ClutterRound> rounds) {
  std::vector<Counts> counts;
  for (const ClutterRound& round : rounds) {
    const auto part = std::count_if(round.attempts.begin(), round.attempts.end(), succeeded);
    counts.push_back({static_cast<std::size_t>(part), round.attempts.size()});
  }
  return share_with_interval(counts);
}

RoundShare declutter_rate(std::span<const ClutterRound> rounds) {
  std::vector<Counts> counts;
  for (const ClutterRound& round : rounds)
    counts.push_back(
        {static_cast<std::size_t>(round.removed), static_cast<std::size_t>(round.placed)});
  return share_with_interval(counts);
}

std::string format_clutter_report(std::span<const ClutterRound> rounds) {
  const std::vector<const ClutterAttempt*> attempts = all_attempts(rounds);
  std::string text;
  append_share(text, "grasp success rate", grasp_success_rate(rounds));
  append_share(text, "declutter rate", declutter_rate(rounds));
  append_occlusion_classes(text, rounds);
  if (!attempts.empty()) append_times(text, attempts);
  append_tally(text, "attempts by outcome", frequencies(attempts, end_label));
  append_tally(text, "hand at the grasp, in the true table or another true object",
               frequencies(attempts, penetration_label));
  append_tally(text, "rounds by their end", frequencies(rounds, [](const ClutterRound& round) {
                 return std::string(to_string(round.end));
               }));
  append_tally(text, "rounds that ended without a grasp: reasons per object",
               missing_grasps(rounds));
  append_tally(text, "success by occlusion of the object", successes(attempts, occlusion_label));
  append_tally(text, "success by quality", successes(attempts, quality_label));
  append_tally(text, "success by source of the grasp",
               successes(attempts, [](const ClutterAttempt& attempt) {
                 return std::string(to_string(attempt.grasp.source));
               }));
  return text;
}

std::string format_attempts_csv(std::span<const ClutterRound> rounds) {
  std::string text =
      "round,attempt,rehearsal,object,present,seen,occlusion,source,quality,opening,aimed_distance";
  const GraspFeatures none;
  GraspFeatures::visit_fields(none,
                              [&](const char* name, double) { text += fmt::format(",{}", name); });
  text +=
      ",success,end,contact,touched_other,removed_other,short_by,closed_width,width,penetration,"
      "seconds\n";
  for (const ClutterRound& round : rounds) {
    for (const ClutterAttempt& attempt : round.attempts) append_row(attempt, false, text);
    for (const ClutterAttempt& attempt : round.rehearsals) append_row(attempt, true, text);
  }
  return text;
}

}  // namespace symscene
