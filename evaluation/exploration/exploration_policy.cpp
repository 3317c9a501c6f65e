#include "symscene/exploration/exploration_policy.hpp"

#include <array>

#include <fmt/format.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr std::array policies{
    ExplorationPolicy::symmetry,         ExplorationPolicy::unknown_voxels,
    ExplorationPolicy::rear_side_voxels, ExplorationPolicy::fixed_arc,
    ExplorationPolicy::random,           ExplorationPolicy::oracle};
constexpr std::array policy_names{"symmetry",  "unknown-voxels", "rear-side-voxels",
                                  "fixed-arc", "random",         "oracle"};

}  // namespace

const char* to_string(ExplorationPolicy policy) {
  return policy_names.at(static_cast<std::size_t>(policy));
}

ExplorationPolicy parse_exploration_policy(std::string_view name) {
  for (const ExplorationPolicy policy : policies) {
    if (name == to_string(policy)) return policy;
  }
  throw InputError("policy", fmt::format("{}", fmt::join(policy_names, ", ")),
                   fmt::format("\"{}\"", name));
}

std::span<const ExplorationPolicy> exploration_policies() { return policies; }

std::optional<ViewPolicy> ranking_policy(ExplorationPolicy policy) {
  switch (policy) {
    case ExplorationPolicy::symmetry:
      return ViewPolicy::symmetry;
    case ExplorationPolicy::unknown_voxels:
      return ViewPolicy::unknown_voxels;
    case ExplorationPolicy::rear_side_voxels:
      return ViewPolicy::rear_side_voxels;
    default:
      return std::nullopt;
  }
}

}  // namespace symscene
