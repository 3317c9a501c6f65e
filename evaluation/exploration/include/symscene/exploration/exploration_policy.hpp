#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "symscene/view_planning/next_view.hpp"

namespace symscene {

/// By what the next view is chosen.
enum class ExplorationPolicy : std::uint8_t {
  symmetry,          ///< ViewPolicy::symmetry
  unknown_voxels,    ///< ViewPolicy::unknown_voxels
  rear_side_voxels,  ///< ViewPolicy::rear_side_voxels
  fixed_arc,         ///< around the scene, always the same way (section 4.6.2 of the thesis)
  random,
  oracle  ///< that which shows most of the true surface that was not seen yet
};

/// The name of a policy in options: "fixed-arc" for fixed_arc.
const char* to_string(ExplorationPolicy policy);
/// Throws InputError if no policy has that name.
ExplorationPolicy parse_exploration_policy(std::string_view name);
/// All policies.
std::span<const ExplorationPolicy> exploration_policies();
/// By which the policy ranks candidates; none if it ranks none.
std::optional<ViewPolicy> ranking_policy(ExplorationPolicy policy);

}  // namespace symscene
