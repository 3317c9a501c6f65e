#include "distinct_grasps.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <vector>

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

/// The group of a grasp: its source and whether it comes from above.
std::size_t group_of(const Grasp& grasp) {
  constexpr double from_above = radians(45.0);
  return 2 * static_cast<std::size_t>(grasp.source) + (grasp.features.tilt < from_above ? 0 : 1);
}

/// Keeps grasps that are near no kept one.
class Choice {
 public:
  Choice(std::span<const Grasp> grasps, GripperKind kind, const GraspOptions& options)
      : grasps_(grasps), kind_(kind), options_(options), is_kept_(grasps.size(), false) {}

  /// Keeps further grasps, in their order, up to `most_per_group` of each group.
  void keep(std::size_t most_per_group) {
    for (std::size_t i = 0; i < grasps_.size(); ++i) {
      if (kept_.size() == static_cast<std::size_t>(options_.max_grasps)) return;
      std::size_t& of_group = counts_.at(group_of(grasps_[i]));
      if (is_kept_[i] || of_group >= most_per_group || is_near_kept(grasps_[i])) continue;
      ++of_group;
      is_kept_[i] = true;
      kept_.push_back(i);
    }
  }

  DistinctGrasps result() const {
    DistinctGrasps result;
    for (std::size_t i = 0; i < grasps_.size(); ++i)
      (is_kept_[i] ? result.kept : result.outranked).push_back(grasps_[i]);
    return result;
  }

 private:
  bool is_near_kept(const Grasp& grasp) const {
    return std::any_of(kept_.begin(), kept_.end(),
                       [&](std::size_t k) { return is_near(grasp, grasps_[k], kind_, options_); });
  }

  std::span<const Grasp> grasps_;
  GripperKind kind_;
  const GraspOptions& options_;
  std::vector<bool> is_kept_;
  std::vector<std::size_t> kept_;
  std::array<std::size_t, 2 * grasp_sources> counts_{};
};

}  // namespace

DistinctGrasps distinct_grasps(std::vector<Grasp> grasps, GripperKind kind,
                               const GraspOptions& options) {
  std::stable_sort(grasps.begin(), grasps.end(), is_better);
  std::set<std::size_t> groups;
  for (const Grasp& grasp : grasps) groups.insert(group_of(grasp));
  const auto room = static_cast<std::size_t>(options.max_grasps);
  Choice choice(grasps, kind, options);
  choice.keep(std::max<std::size_t>(room / std::max<std::size_t>(groups.size(), 1), 1));
  choice.keep(room);
  return choice.result();
}

}  // namespace symscene
