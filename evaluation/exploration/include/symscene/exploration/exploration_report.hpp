#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "symscene/exploration/exploration.hpp"

namespace symscene {

/// The mean of differences between two policies on the same scenes, and its 95 % interval by
/// resampling scenes.
struct PairedDifference {
  double mean = 0.0;
  double low = 0.0;
  double high = 0.0;
  std::size_t scenes = 0;
};

/// Zero without differences; one per scene.
PairedDifference paired_difference(std::span<const double> differences);

/// Tables for people: each measure by policy and number of views, areas under the curves, and
/// differences of `reference` from the other policies. Scenes that a policy did not finish are left
/// out of all policies.
std::string format_exploration_report(std::span<const Exploration> explorations,
                                      ExplorationPolicy reference = ExplorationPolicy::symmetry);

/// One line per view: kind and number of the scene, policy, number of the view, candidate,
/// observed, completed, masks, axes and planes (each correct, found, true), grasped (1, 0 or
/// empty), seconds of the decision.
std::string format_explorations_csv(std::span<const Exploration> explorations);

}  // namespace symscene
