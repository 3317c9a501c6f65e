#pragma once

#include <span>
#include <string>
#include <vector>

#include "symscene/clutter/clutter_rounds.hpp"
#include "symscene/clutter/round_share.hpp"

namespace symscene {

/// Successful grasps over attempts.
RoundShare grasp_success_rate(std::span<const ClutterRound> rounds);
/// Removed objects over those that were placed.
RoundShare declutter_rate(std::span<const ClutterRound> rounds);

/// The figures of a benchmark for people: rates, also of objects that are half or more hidden and
/// of the others, how attempts and rounds ended, success by occlusion and source of the grasp,
/// planning time.
std::string format_clutter_report(std::span<const ClutterRound> rounds);

/// One line per attempt with its features and outcome, the names of the columns first.
std::string format_attempts_csv(std::span<const ClutterRound> rounds);

}  // namespace symscene
