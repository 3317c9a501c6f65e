#include "symscene/grasping/planner.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.hpp"
#include "grasp_judge.hpp"
#include "rejected_grasps.hpp"
#include "surface_checks.hpp"

namespace symscene {
namespace {

/// What became of one object.
struct ObjectPlan {
  std::vector<Grasp> grasps;
  std::vector<RejectedGrasp> rejected;
  ObjectGraspSummary summary;
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  std::array<std::size_t, grasp_rejections> level{};  ///< rejected ones that close about level

  void reject(const RejectedGrasp& rejection) {
    constexpr double steepest = 0.7;  // sine of the angle to level
    const auto reason = static_cast<std::size_t>(rejection.reason);
    ++summary.rejected.at(reason);
    if (std::abs(rejection.grasp.T_world_tool.linear().col(1).dot(up)) < steepest)
      ++level.at(reason);
    rejected.push_back(rejection);
  }
  void keep_distinct(GripperKind kind, const GraspOptions& options);
  void name_reason();
};

bool is_better(const Grasp& a, const Grasp& b) { return a.quality > b.quality; }

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

/// Keeps the best grasps that differ from each other.
void ObjectPlan::keep_distinct(GripperKind kind, const GraspOptions& options) {
  std::stable_sort(grasps.begin(), grasps.end(), is_better);
  std::vector<Grasp> kept;
  for (const Grasp& grasp : grasps) {
    const bool is_full = kept.size() >= static_cast<std::size_t>(options.max_grasps);
    const bool repeats = std::any_of(kept.begin(), kept.end(), [&](const Grasp& better) {
      return is_near(grasp, better, kind, options);
    });
    if (is_full || repeats)
      reject({grasp, GraspRejection::outranked, grasp.quality, kept.front().quality});
    else
      kept.push_back(grasp);
  }
  grasps = std::move(kept);
  summary.grasps = grasps.size();
}

/// Without a grasp: the bound that most candidates failed. Those that close steeply count only if
/// there are no others, as under an object there is the table.
void ObjectPlan::name_reason() {
  if (!grasps.empty()) return;
  const bool has_level = std::any_of(level.begin(), level.end(), [](auto n) { return n > 0; });
  const auto& counts = has_level ? level : summary.rejected;
  const auto most = std::max_element(counts.begin(), counts.end());
  summary.reason =
      *most == 0 ? GraspRejection::no_contact : static_cast<GraspRejection>(most - counts.begin());
}

std::vector<ClosingLine> closing_lines(const GraspTarget& target,
                                       const GraspCandidateOptions& options) {
  std::vector<ClosingLine> lines;
  for (const auto& make : {box_lines, axis_lines, rim_lines, mirror_lines, antipodal_lines}) {
    const std::vector<ClosingLine> more = make(target, options);
    lines.insert(lines.end(), more.begin(), more.end());
  }
  return lines;
}

RejectedGrasp too_wide(const GraspTarget& target, const ApproachPose& pose, double width,
                       double bound) {
  Grasp grasp;
  grasp.object = target.object;
  grasp.T_world_tool = pose.T_world_tool;
  grasp.opening = width;
  grasp.source = pose.source;
  return {grasp, GraspRejection::too_wide, width, bound};
}

/// Why no candidate of the object is worth a look.
std::optional<GraspRejection> reason_against(const GraspSurroundings& around, std::size_t id) {
  if (around.objects[id].size() == 0) return GraspRejection::no_surface;
  if (around.unknown && around.unknown->is_outside(around.objects[id]))
    return GraspRejection::outside_space;
  return std::nullopt;
}

ObjectPlan plan_object(const GraspSurroundings& around, std::size_t id, const Gripper& gripper,
                       const GraspOptions& options) {
  ObjectPlan plan;
  plan.summary.reason = reason_against(around, id);
  if (plan.summary.reason) return plan;
  const GraspTarget target = grasp_target(around.scene, id, around.objects);
  if (!(target.solid.volume > 0.0)) {
    plan.summary.reason = GraspRejection::no_surface;
    return plan;
  }
  plan.up = target.up;
  const GraspJudge judge(around, target, gripper, options);
  const double widest = gripper.max_opening - options.bounds.opening_clearance;
  for (const ClosingLine& line : closing_lines(target, options.candidates)) {
    for (const ApproachPose& pose :
         approach_poses(target, line, gripper, around.scene.table, options)) {
      ++plan.summary.candidates;
      if (line.width > widest) {
        plan.reject(too_wide(target, pose, line.width, widest));
        continue;
      }
      const GraspJudge::Verdict verdict = judge.judge(pose);
      if (verdict.reason)
        plan.reject({verdict.grasp, *verdict.reason, verdict.value, verdict.bound});
      else
        plan.grasps.push_back(verdict.grasp);
    }
  }
  plan.keep_distinct(gripper.kind, options);
  plan.name_reason();
  plan.rejected = some_of_each_reason(plan.rejected, options.max_rejected);
  return plan;
}

GraspSurroundings surroundings(const GraspScene& scene, const GraspOptions& options) {
  GraspSurroundings around{scene, {}, surface_samples(scene.obstacles), std::nullopt};
  around.objects.resize(scene.objects.size());
  parallel_for_each(around.objects.size(), [&](std::size_t i) {
    around.objects[i] = surface_samples(scene.objects[i].surface);
  });
  if (scene.space) {
    around.unknown.emplace(*scene.space, around.objects, around.others,
                           static_cast<float>(options.bounds.own_reach));
  }
  return around;
}

GraspPlan joined(const std::vector<ObjectPlan>& objects) {
  GraspPlan plan;
  for (const ObjectPlan& object : objects) {
    plan.grasps.insert(plan.grasps.end(), object.grasps.begin(), object.grasps.end());
    plan.rejected.insert(plan.rejected.end(), object.rejected.begin(), object.rejected.end());
    plan.objects.push_back(object.summary);
  }
  std::stable_sort(plan.grasps.begin(), plan.grasps.end(), is_better);
  return plan;
}

}  // namespace

GraspPlan plan_grasps(const GraspScene& scene, const Gripper& gripper,
                      const GraspOptions& options) {
  gripper.validate();
  options.validate();
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    require_moderate_size(scene.objects[i].surface, i);
  StageTimer timer;
  const GraspSurroundings around =
      timer.time("surroundings", [&] { return surroundings(scene, options); });
  std::vector<ObjectPlan> objects(scene.objects.size());
  timer.time("candidates", [&] {
    parallel_for_each(objects.size(), [&](std::size_t i) {
      objects[i] = plan_object(around, i, gripper, options);
    });
  });
  GraspPlan plan = timer.time("ranking", [&] { return joined(objects); });
  plan.timings = timer.stages();
  return plan;
}

}  // namespace symscene
