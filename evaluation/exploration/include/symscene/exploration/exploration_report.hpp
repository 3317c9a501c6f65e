#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "symscene/exploration/exploration.hpp"

// The comparison of policies over the explorations of the same scenes. Scenes of each kind are
// compared among themselves; those that a policy did not finish are left out of all policies.
// Intervals are 95 % by resampling scenes.
namespace symscene {

/// Tables for people: each measure by policy and number of views, and differences of `reference`
/// from the other policies.
std::string format_exploration_report(std::span<const Exploration> explorations,
                                      ExplorationPolicy reference = ExplorationPolicy::symmetry);

/// The same with curves over the number of views, as one self-contained HTML page without scripts
/// in the style of the report of an evaluation. `made_with` tells what made it, as text.
std::string format_exploration_report_page(
    std::span<const Exploration> explorations, const std::string& made_with,
    ExplorationPolicy reference = ExplorationPolicy::symmetry);

/// One line per view: kind and number of the scene, policy, number of the view, candidate,
/// observed, completed, masks, axes and planes (each correct, found, true), grasped (1, 0 or
/// empty), seconds of the decision.
std::string format_explorations_csv(std::span<const Exploration> explorations);

/// The explorations of that text. `name` stands for it in messages. Throws InputError if it is not
/// such a table or has no view.
std::vector<Exploration> parse_explorations_csv(std::string_view csv, const std::string& name);

}  // namespace symscene
