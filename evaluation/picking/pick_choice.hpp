#pragma once

#include <optional>
#include <string>
#include <vector>

#include "failed_attempts.hpp"
#include "left_reasons.hpp"
#include "pick_execution.hpp"
#include "place_motion.hpp"
#include "table_belief.hpp"

namespace symscene {

/// The pick that is executed next, or why there is none.
struct PickChoice {
  std::optional<PlannedPick> planned;
  std::vector<BeliefFate> fates;  ///< one per object of the belief
  std::string no_pick;
};

/// The point between the finger tips of a grasp.
Eigen::Vector3d tip_point(const Grasp& grasp, const Gripper& gripper);

/// The best grasp to which the arm has a motion, and from it one to the bin. Objects on which
/// attempts failed come after all others, and are given up after `max_object_failures`, a place on
/// them after `max_failures`. Where there is none, a lifted object may push its neighbours by
/// `crowded_lift_slack`. `start`: positions of all moving joints.
PickChoice choose_pick(const PickScene& in, const TableBelief& belief, const Eigen::VectorXd& start,
                       const FailedAttempts& failed, StageTimer& timer);

}  // namespace symscene
