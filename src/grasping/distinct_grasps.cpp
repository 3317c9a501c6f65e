#include "distinct_grasps.hpp"

#include <algorithm>
#include <array>
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

/// The source of a grasp and whether it comes from above.
std::size_t kind_of(const Grasp& grasp) {
  constexpr double from_above = radians(45.0);
  return 2 * static_cast<std::size_t>(grasp.source) + (grasp.features.tilt < from_above ? 0 : 1);
}

/// Which of the grasps, in descending order of quality, are kept where there is room for `room`:
/// the best of each kind up to an equal share of it, then the best of the others.
std::vector<bool> kept_of_each_kind(const std::vector<Grasp>& grasps, std::size_t room) {
  std::array<std::size_t, 2 * grasp_sources> counts{}, taken{};
  for (const Grasp& grasp : grasps) ++counts.at(kind_of(grasp));
  const auto kinds = static_cast<std::size_t>(
      std::count_if(counts.begin(), counts.end(), [](std::size_t n) { return n > 0; }));
  std::vector<bool> kept(grasps.size(), false);
  std::size_t left = room;
  const auto keep = [&](std::size_t i) {
    kept[i] = true;
    --left;
  };
  for (std::size_t i = 0; i < grasps.size() && left > 0; ++i) {
    std::size_t& of_kind = taken.at(kind_of(grasps[i]));
    if (of_kind < std::max<std::size_t>(room / kinds, 1)) {
      ++of_kind;
      keep(i);
    }
  }
  for (std::size_t i = 0; i < grasps.size() && left > 0; ++i) {
    if (!kept[i]) keep(i);
  }
  return kept;
}

}  // namespace

DistinctGrasps distinct_grasps(std::vector<Grasp> grasps, GripperKind kind,
                               const GraspOptions& options) {
  std::stable_sort(grasps.begin(), grasps.end(), is_better);
  std::vector<Grasp> distinct;
  const auto room = static_cast<std::size_t>(options.max_grasps);
  std::array<std::size_t, 2 * grasp_sources> counts{};
  DistinctGrasps result;
  for (const Grasp& grasp : grasps) {
    std::size_t& of_kind = counts.at(kind_of(grasp));
    const auto is_repeated = [&] {
      return std::any_of(distinct.begin(), distinct.end(), [&](const Grasp& better) {
        return is_near(grasp, better, kind, options);
      });
    };
    if (of_kind == room || is_repeated()) {
      result.outranked.push_back(grasp);
      continue;
    }
    ++of_kind;
    distinct.push_back(grasp);
  }
  const std::vector<bool> kept = kept_of_each_kind(distinct, room);
  for (std::size_t i = 0; i < distinct.size(); ++i)
    (kept[i] ? result.kept : result.outranked).push_back(distinct[i]);
  std::stable_sort(result.outranked.begin(), result.outranked.end(), is_better);
  return result;
}

}  // namespace symscene
