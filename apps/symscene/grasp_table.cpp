#include "grasp_table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "symscene/core/types.hpp"

namespace symscene::app {
namespace {

std::string best_grasp_of(const GraspPlan& plan, std::size_t id) {
  const auto best = std::find_if(plan.grasps.begin(), plan.grasps.end(), [&](const Grasp& grasp) {
    return grasp.object == static_cast<int>(id);
  });
  if (best == plan.grasps.end()) return "";
  return fmt::format("{:>7.2f}  {:>7.1f}  {:>4.0f}  {}", best->quality, 1000.0 * best->opening,
                     degrees(best->features.tilt), to_string(best->source));
}

/// "none of 340 candidates: the gripper would hit the table".
std::string reason_against(const ObjectGraspSummary& object) {
  if (!object.reason) return "";
  if (object.candidates == 0) return fmt::format("  none: {}", description(*object.reason));
  return fmt::format("  none of {} candidates: {}", object.candidates, description(*object.reason));
}

}  // namespace

std::size_t graspable_objects(const GraspPlan& plan) {
  return static_cast<std::size_t>(
      std::count_if(plan.objects.begin(), plan.objects.end(),
                    [](const ObjectGraspSummary& object) { return object.grasps > 0; }));
}

std::string format_grasps(const GraspPlan& plan) {
  std::string table =
      " id  grasps  quality  opening  tilt  best grasp from\n"
      "                          [mm] [deg]";
  for (std::size_t id = 0; id < plan.objects.size(); ++id) {
    const ObjectGraspSummary& object = plan.objects[id];
    table += fmt::format("\n{:>3}  {:>6}", id, object.grasps);
    table += object.grasps > 0 ? "  " + best_grasp_of(plan, id) : reason_against(object);
  }
  table +=
      fmt::format("\n{} of {} objects have a grasp", graspable_objects(plan), plan.objects.size());
  return table;
}

}  // namespace symscene::app
