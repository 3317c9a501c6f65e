#include "planned_pick.hpp"

#include <utility>

namespace symscene::app {

PlannedPick planned_pick(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                         const Eigen::VectorXd& start, const GraspScene& scene,
                         std::span<const Grasp> grasps, const PickOptions& options, bool all) {
  PlannedPick planned;
  for (std::size_t first = 0; first == 0 || first < grasps.size();) {
    PickResult pick = plan_pick(robot, arm, gripper, start, scene, grasps.subspan(first), options);
    planned.start_contact = pick.start_contact;
    for (const StageTime& time : pick.timings) add_to_sums(planned.timings, time);
    for (RejectedPick& why : pick.rejected) {
      why.grasp += first;
      planned.rejected.push_back(std::move(why));
    }
    if (!pick.motion && all && !pick.rejected.empty()) {
      first += pick.rejected.size();  // at most max_grasps are judged at once
      continue;
    }
    if (!pick.motion) break;
    pick.motion->grasp += first;
    first = pick.motion->grasp + 1;
    planned.reached.push_back(pick.motion->grasp);
    if (!planned.motion) planned.motion = std::move(pick.motion);
    if (!all) break;
  }
  return planned;
}

}  // namespace symscene::app
