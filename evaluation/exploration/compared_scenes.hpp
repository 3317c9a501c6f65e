#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "symscene/exploration/exploration.hpp"

namespace symscene {

/// Explorations of one policy, one per scene by ascending number.
using PolicyExplorations = std::vector<const Exploration*>;

/// Scenes of one kind that every policy explored with the same number of views.
struct ComparedScenes {
  std::string kind;
  std::map<ExplorationPolicy, PolicyExplorations> by_policy;

  std::size_t scenes() const { return by_policy.empty() ? 0 : by_policy.begin()->second.size(); }
  /// Per exploration.
  std::size_t views() const {
    return scenes() == 0 ? 0 : by_policy.begin()->second.front()->steps.size();
  }
};

/// The explorations by kind of scene, in the order in which kinds come first. Scenes that some
/// policy of their kind did not explore, or with fewer views than others, are left out. The
/// explorations must outlive the result.
std::vector<ComparedScenes> compared_scenes(std::span<const Exploration> explorations);

}  // namespace symscene
