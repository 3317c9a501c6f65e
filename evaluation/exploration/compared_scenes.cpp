#include "compared_scenes.hpp"

#include <algorithm>

namespace symscene {
namespace {

std::vector<std::string> kinds_of(std::span<const Exploration> explorations) {
  std::vector<std::string> kinds;
  for (const Exploration& e : explorations) {
    if (std::find(kinds.begin(), kinds.end(), e.kind) == kinds.end()) kinds.push_back(e.kind);
  }
  return kinds;
}

/// By number, then by policy, those with the most views.
using ByScene = std::map<int, std::map<ExplorationPolicy, const Exploration*>>;

ByScene finished_by_scene(std::span<const Exploration> explorations, const std::string& kind) {
  std::size_t most = 0;
  for (const Exploration& e : explorations) {
    if (e.kind == kind) most = std::max(most, e.steps.size());
  }
  ByScene by_scene;
  for (const Exploration& e : explorations) {
    if (e.kind == kind && e.steps.size() == most) by_scene[e.scene][e.policy] = &e;
  }
  return by_scene;
}

}  // namespace

std::vector<ComparedScenes> compared_scenes(std::span<const Exploration> explorations) {
  std::vector<ComparedScenes> all;
  for (const std::string& kind : kinds_of(explorations)) {
    const ByScene by_scene = finished_by_scene(explorations, kind);
    std::size_t policies = 0;
    for (const auto& [scene, own] : by_scene) policies = std::max(policies, own.size());
    ComparedScenes compared{kind, {}};
    for (const auto& [scene, own] : by_scene) {
      if (own.size() < policies) continue;
      for (const auto& [policy, exploration] : own)
        compared.by_policy[policy].push_back(exploration);
    }
    if (compared.views() > 0) all.push_back(std::move(compared));
  }
  return all;
}

}  // namespace symscene
