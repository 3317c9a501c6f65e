#include "object_planner.hpp"

#include <algorithm>
#include <cmath>

#include "distinct_grasps.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {
namespace {

std::vector<ClosingLine> closing_lines(const GraspTarget& target,
                                       const GraspCandidateOptions& options) {
  std::vector<ClosingLine> lines;
  for (const auto& make : {box_lines, axis_lines, rim_lines, mirror_lines, antipodal_lines}) {
    const std::vector<ClosingLine> more = make(target, options);
    lines.insert(lines.end(), more.begin(), more.end());
  }
  return lines;
}

void append(JudgedLines& all, const JudgedLines& more) {
  all.candidates += more.candidates;
  all.grasps.insert(all.grasps.end(), more.grasps.begin(), more.grasps.end());
  all.rejected.insert(all.rejected.end(), more.rejected.begin(), more.rejected.end());
  all.reasons.insert(all.reasons.end(), more.reasons.begin(), more.reasons.end());
  for (std::size_t i = 0; i < all.level.size(); ++i) all.level[i] += more.level[i];
}

/// Whether candidates with this reason had contacts that hold. Of those at the table that is not
/// known.
bool is_after_contact(std::size_t reason) {
  const auto rejection = static_cast<GraspRejection>(reason);
  return rejection > GraspRejection::table && rejection <= GraspRejection::low_quality;
}

/// Without a grasp: the bound that most candidates failed. Those that close steeply count only if
/// there are no others, as under an object there is the table. If more than a few places can be
/// held, that others cannot does not count.
GraspRejection main_reason(const JudgedLines& judged, const ObjectGraspSummary& summary) {
  constexpr std::size_t few = 20;  // of the candidates, one in so many
  const bool has_level =
      std::any_of(judged.level.begin(), judged.level.end(), [](auto n) { return n > 0; });
  auto counts = has_level ? judged.level : summary.rejected;
  std::size_t all = 0, held = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    all += counts[i];
    if (is_after_contact(i)) held += counts[i];
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (few * held > all && static_cast<GraspRejection>(i) < GraspRejection::table) counts[i] = 0;
  }
  const auto most = std::max_element(counts.begin(), counts.end());
  return *most == 0 ? GraspRejection::no_contact
                    : static_cast<GraspRejection>(most - counts.begin());
}

ObjectGraspSummary summary_of(const JudgedLines& judged, const DistinctGrasps& distinct) {
  ObjectGraspSummary summary;
  summary.candidates = judged.candidates;
  summary.grasps = distinct.kept.size();
  for (const GraspRejection reason : judged.reasons)
    ++summary.rejected.at(static_cast<std::size_t>(reason));
  if (summary.grasps == 0) summary.reason = main_reason(judged, summary);
  summary.rejected.at(static_cast<std::size_t>(GraspRejection::outranked)) =
      distinct.outranked.size();
  return summary;
}

}  // namespace

ObjectPlanner::ObjectPlanner(const GraspSurroundings& around, const GraspTarget& target,
                             const Gripper& gripper, const GraspOptions& options)
    : around_(around),
      gripper_(gripper),
      options_(options),
      target_(target),
      judge_(around, target_, gripper, options),
      lines_(closing_lines(target_, options.candidates)),
      widest_(gripper.max_opening - options.bounds.opening_clearance) {}

std::vector<ApproachPose> ObjectPlanner::poses_of(const ClosingLine& line) const {
  return approach_poses(target_, line, gripper_, around_.scene.table, options_);
}

JudgedLines ObjectPlanner::judge(std::size_t begin, std::size_t end) const {
  JudgedLines judged;
  for (std::size_t line = begin; line < end; ++line) judge_line(line, judged);
  return judged;
}

void ObjectPlanner::judge_line(std::size_t line, JudgedLines& judged) const {
  constexpr double steepest = 0.7;  // sine of the angle to level
  const bool is_level = std::abs(lines_[line].direction.dot(target_.up)) < steepest;
  const auto reject = [&](std::size_t pose, GraspRejection reason) {
    judged.rejected.push_back({static_cast<Index>(line), static_cast<Index>(pose)});
    judged.reasons.push_back(reason);
    if (is_level) ++judged.level.at(static_cast<std::size_t>(reason));
  };
  const std::vector<ApproachPose> poses = poses_of(lines_[line]);
  judged.candidates += poses.size();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (lines_[line].width > widest_) {
      reject(i, GraspRejection::too_wide);
      continue;
    }
    const auto verdict = judge_.judge(poses[i], GraspJudge::Search::to_bound);
    if (verdict.reason)
      reject(i, *verdict.reason);
    else
      judged.grasps.push_back(verdict.grasp);
  }
}

RejectedGrasp ObjectPlanner::rejected_grasp(const RejectedPose& rejected) const {
  const ClosingLine& line = lines_[rejected.line];
  const ApproachPose pose = poses_of(line)[rejected.pose];
  if (line.width > widest_) {
    const Grasp grasp{.object = target_.object,
                      .T_world_tool = pose.T_world_tool,
                      .opening = line.width,
                      .source = pose.source};
    return {grasp, GraspRejection::too_wide, line.width, widest_};
  }
  const auto verdict = judge_.judge(pose, GraspJudge::Search::complete);
  return {verdict.grasp, *verdict.reason, verdict.value, verdict.bound};
}

ObjectPlan ObjectPlanner::plan(std::span<const JudgedLines> blocks) const {
  JudgedLines all;
  for (const JudgedLines& block : blocks) append(all, block);
  const DistinctGrasps distinct = distinct_grasps(all.grasps, gripper_.kind, options_);
  ObjectPlan plan{distinct.kept, {}, summary_of(all, distinct)};
  for (const Index i : some_of_each_reason(all.reasons, options_.max_rejected))
    plan.rejected.push_back(rejected_grasp(all.rejected[i]));
  const auto outranked = static_cast<Index>(distinct.outranked.size());
  for (const Index i : evenly_spread(outranked, static_cast<Index>(options_.max_rejected))) {
    const Grasp& grasp = distinct.outranked[i];
    plan.rejected.push_back(
        {grasp, GraspRejection::outranked, grasp.quality, distinct.kept.front().quality});
  }
  return plan;
}

}  // namespace symscene
