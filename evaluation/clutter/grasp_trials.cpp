#include "symscene/clutter/grasp_trials.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace symscene {
namespace {

constexpr double rest_speed = 0.01;  // [m/s]

GraspOutcome executed(GraspWorld& world, const Eigen::Isometry3d& T_table_tool,
                      const GraspExecutionOptions& options) {
  const GraspOutcome outcome = execute_grasp(world, T_table_tool, options);
  world.take_hand_away();
  return outcome;
}

}  // namespace

std::vector<std::size_t> present_bodies(const GraspWorld& world) {
  std::vector<std::size_t> bodies;
  for (std::size_t b = 0; b < world.size(); ++b) {
    if (world.is_there(b)) bodies.push_back(b);
  }
  return bodies;
}

bool is_at_rest(const GraspWorld& world) {
  const std::vector<std::size_t> bodies = present_bodies(world);
  return std::all_of(bodies.begin(), bodies.end(),
                     [&](std::size_t b) { return world.speed(b) <= rest_speed; });
}

double hand_penetration(GraspWorld& world, const Eigen::Isometry3d& T_table_tool,
                        std::size_t aimed) {
  world.put_hand(T_table_tool);
  const HandContacts contacts = world.hand_contacts();
  world.take_hand_away();
  double depth = contacts.table_depth;
  for (std::size_t k = 0; k < contacts.bodies.size(); ++k) {
    if (contacts.bodies[k] != aimed) depth = std::max(depth, contacts.depths[k]);
  }
  return depth;
}

GraspOutcome execute_and_remove(GraspWorld& world, const Eigen::Isometry3d& T_table_tool,
                                const GraspExecutionOptions& options) {
  const GraspOutcome outcome = executed(world, T_table_tool, options);
  if (outcome.end == GraspEnd::success) world.take_away(*outcome.body);
  return outcome;
}

GraspOutcome execute_and_undo(GraspWorld& world, const Eigen::Isometry3d& T_table_tool,
                              const GraspExecutionOptions& options) {
  const std::vector<std::size_t> bodies = present_bodies(world);
  std::vector<Eigen::Isometry3d> poses;
  for (const std::size_t b : bodies) poses.push_back(world.pose(b));
  const GraspOutcome outcome = executed(world, T_table_tool, options);
  for (std::size_t k = 0; k < bodies.size(); ++k) world.put(bodies[k], poses[k]);
  return outcome;
}

std::string outcome_label(const GraspOutcome& outcome, bool touched_other) {
  const std::string end = to_string(outcome.end);
  if (outcome.contact == ApproachContact::none) return end;
  return fmt::format("{}, touched {}", end,
                     outcome.contact == ApproachContact::table ? "the table"
                     : touched_other                           ? "another object"
                                                               : "its object");
}

}  // namespace symscene
