#include "distinct_grasps.hpp"

#include <algorithm>

#include "object_plan.hpp"

namespace symscene {
namespace {

/// The angle between two poses of a gripper. Half a turn about z does not change a parallel one.
double turned_by(const Grasp& a, const Grasp& b, GripperKind kind) {
  const Eigen::Matrix3d turn = a.T_world_tool.linear().transpose() * b.T_world_tool.linear();
  const double same = Eigen::AngleAxisd(turn).angle();
  if (kind != GripperKind::parallel) return same;
  const Eigen::Matrix3d half = Eigen::Vector3d(-1.0, -1.0, 1.0).asDiagonal();
  return std::min(same, Eigen::AngleAxisd(turn * half).angle());
}

bool is_near(const Grasp& a, const Grasp& b, GripperKind kind, const GraspOptions& options) {
  const double distance = (a.T_world_tool.translation() - b.T_world_tool.translation()).norm();
  return distance < options.distinct_distance && turned_by(a, b, kind) < options.distinct_angle;
}

}  // namespace

DistinctGrasps distinct_grasps(std::vector<Grasp> grasps, GripperKind kind,
                               const GraspOptions& options) {
  std::stable_sort(grasps.begin(), grasps.end(), is_better);
  DistinctGrasps result;
  for (const Grasp& grasp : grasps) {
    const bool is_full = result.kept.size() >= static_cast<std::size_t>(options.max_grasps);
    const auto is_repeated = [&] {
      return std::any_of(result.kept.begin(), result.kept.end(), [&](const Grasp& better) {
        return is_near(grasp, better, kind, options);
      });
    };
    (is_full || is_repeated() ? result.outranked : result.kept).push_back(grasp);
  }
  return result;
}

}  // namespace symscene
