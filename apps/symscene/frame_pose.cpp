#include "frame_pose.hpp"

#include <cmath>

namespace symscene::app {
namespace {

std::optional<Eigen::Isometry3d> pose_at(const Trajectory& trajectory, double time) {
  for (const StampedPose& pose : trajectory) {
    if (std::abs(pose.time - time) < 1e-3) return pose.T_world_camera;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Eigen::Isometry3d> frame_pose(const Trajectory& trajectory,
                                            const DepthSequence& sequence, std::size_t i) {
  if (!trajectory.empty()) return pose_at(trajectory, sequence.time(i));
  if (const auto own = sequence.pose(i)) return own;
  if (sequence.size() == 1) return Eigen::Isometry3d::Identity();
  return std::nullopt;
}

}  // namespace symscene::app
