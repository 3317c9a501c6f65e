#pragma once

#include <string>
#include <vector>

#include "symscene/clutter/grasp_execution.hpp"

// What the worlds of the benchmarks do with a hand. Poses are in the table's frame.
namespace symscene {

/// The bodies that are in the world, ascending.
std::vector<std::size_t> present_bodies(const GraspWorld& world);
/// Whether no point of a present body is faster than 1 cm/s, as in VGN's benchmark.
bool is_at_rest(const GraspWorld& world);

/// How far the open hand at a grasp reaches into the table or a body other than `aimed`. [m]
double hand_penetration(GraspWorld& world, const Eigen::Isometry3d& T_table_tool,
                        std::size_t aimed);

/// Executes a grasp and takes the hand, and a body that it holds, out of the world.
GraspOutcome execute_and_remove(GraspWorld& world, const Eigen::Isometry3d& T_table_tool,
                                const GraspExecutionOptions& options);
/// Executes a grasp, takes the hand away and puts all bodies back to where they were, at rest.
GraspOutcome execute_and_undo(GraspWorld& world, const Eigen::Isometry3d& T_table_tool,
                              const GraspExecutionOptions& options);

/// How an execution ended and what its approach touched, for people.
std::string outcome_label(const GraspOutcome& outcome, bool touched_other);

}  // namespace symscene
