#include "symscene/core/error.hpp"
#include "symscene/motion/pick.hpp"

namespace symscene {
namespace {

/// Appends a motion after the last point, which it starts at. Both ends rest: controllers that
/// interpolate accelerations would else swing past them.
void append(const char* name, const TimedPath& motion, double period, JointTrajectory& trajectory) {
  const double start = trajectory.points.empty() ? 0.0 : trajectory.points.back().time;
  JointTrajectoryPart part{name, trajectory.points.empty() ? 0 : trajectory.points.size() - 1, 0};
  for (const JointState& state : sampled(motion, period)) {
    if (state.time == 0.0 && !trajectory.points.empty()) continue;
    trajectory.points.push_back(
        {start + state.time, state.position, state.velocity, state.acceleration});
  }
  trajectory.points[part.begin].accelerations.setZero();
  trajectory.points.back().accelerations.setZero();
  part.end = trajectory.points.size() - 1;
  trajectory.parts.push_back(part);
}

void append_pause(double pause, JointTrajectory& trajectory) {
  JointTrajectoryPoint point = trajectory.points.back();
  point.time += pause;
  point.velocities.setZero();
  trajectory.parts.push_back({"grasp", trajectory.points.size() - 1, trajectory.points.size()});
  trajectory.points.push_back(point);
}

}  // namespace

JointTrajectory pick_trajectory(const PickMotion& motion, const RobotModel& model, const Arm& arm,
                                const Gripper& gripper, double opening, double period,
                                double pause) {
  require_option(pause > 0.0, "pause", "a time above 0", pause);
  JointTrajectory trajectory;
  for (const std::size_t position : arm.positions)
    trajectory.joint_names.push_back(model.joints[model.joint_of_position(position)].name);
  append("to_pre_grasp", motion.to_pre_grasp, period, trajectory);
  append("approach", motion.approach, period, trajectory);
  trajectory.gripper = {{0.0, gripper.max_opening}, {trajectory.points.back().time, opening}};
  append_pause(pause, trajectory);
  append("retreat", motion.retreat, period, trajectory);
  return trajectory;
}

}  // namespace symscene
