#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "symscene/motion/pick.hpp"
#include "symscene/picking/pick_run.hpp"
#include "table_belief.hpp"

namespace symscene {

/// What became of an object that the robot believed in, at the last look.
struct BeliefFate {
  std::size_t grasps = 0;
  int failures = 0;                        ///< attempts that failed on it
  std::size_t given_up = 0;                ///< of the grasps, as attempts failed there or on it
  std::vector<RejectedPick> rejected;      ///< grasps that the arm cannot take
  std::optional<GraspRejection> no_grasp;  ///< why it has none
};

/// The reason in words for which an object is left. `attempts`: those at that object.
/// `fate`: none if the last look did not find it.
std::string reason_left(const std::optional<BeliefFate>& fate,
                        std::span<const PickAttempt> attempts);
/// The same of an object that is not on the table any more, nor in the bin.
std::string reason_fallen(std::span<const PickAttempt> attempts);

}  // namespace symscene
