#pragma once

#include "recorded_run.hpp"
#include "symscene/viewer/plan_page.hpp"

namespace symscene {

/// The motion of carried_box() as a plan, with four grasps and a map of three by two cells.
inline PlanRecording planned_box() {
  PlanRecording plan;
  plan.motion = carried_box();
  plan.motion.beliefs.clear();
  plan.motion.left.clear();
  plan.finger_depth = 0.04;
  const std::vector<std::pair<ShownGraspState, std::string>> states{
      {ShownGraspState::not_reached, "a joint would leave its limits"},
      {ShownGraspState::chosen, ""},
      {ShownGraspState::reached, ""},
      {ShownGraspState::not_tried, ""}};
  for (std::size_t i = 0; i < states.size(); ++i) {
    ShownGrasp shown{3 + i, {}, states[i].first, states[i].second};
    shown.grasp.object = i < 2 ? 0 : 1;
    shown.grasp.quality = 0.9 - 0.1 * static_cast<double>(i);
    shown.grasp.opening = 0.06;
    const Eigen::AngleAxisd down(std::numbers::pi, Eigen::Vector3d::UnitX());
    shown.grasp.T_world_tool = placed_at(0.4 + 0.03 * static_cast<double>(i), 0.0, 0.25) * down;
    plan.grasps.push_back(shown);
  }
  ShownReach reach{0.2, 0.1, Points(6, 3), {}, {}};
  for (int i = 0; i < 6; ++i) {
    reach.centers.row(i) << 0.2F * static_cast<float>(i % 3), 0.2F * static_cast<float>(i / 3), 0;
    reach.from_above.push_back(0.2F * static_cast<float>(i));
    reach.from_side.push_back(0.0F);
  }
  plan.reach = reach;
  return plan;
}

}  // namespace symscene
