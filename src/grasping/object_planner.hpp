#pragma once

#include <array>
#include <span>
#include <vector>

#include "closing_lines.hpp"
#include "grasp_judge.hpp"
#include "object_plan.hpp"

namespace symscene {

/// A candidate that failed a bound: a pose of approach_poses() to a line.
struct RejectedPose {
  Index line;
  Index pose;
};

/// What became of the candidates of some lines. The rejected ones are kept without their grasps, as
/// there are many of them and few are reported.
struct JudgedLines {
  std::size_t candidates = 0;
  std::vector<Grasp> grasps;
  std::vector<RejectedPose> rejected;
  std::vector<GraspRejection> reasons;                ///< one per rejected pose
  std::array<std::size_t, grasp_rejections> level{};  ///< rejected ones that close about level
};

/// Finds the grasps of one object. Its lines can be judged in parallel.
class ObjectPlanner {
 public:
  /// Keeps references to all of these but the target.
  ObjectPlanner(const GraspSurroundings& around, const GraspTarget& target, const Gripper& gripper,
                const GraspOptions& options);
  ObjectPlanner(const ObjectPlanner&) = delete;  // the judge refers to the target

  std::size_t lines() const { return lines_.size(); }
  JudgedLines judge(std::size_t begin, std::size_t end) const;
  /// The plan of the object from all its lines, in their order.
  ObjectPlan plan(std::span<const JudgedLines> blocks) const;

 private:
  std::vector<ApproachPose> poses_of(const ClosingLine& line) const;
  void judge_line(std::size_t line, JudgedLines& judged) const;
  RejectedGrasp rejected_grasp(const RejectedPose& rejected) const;

  const GraspSurroundings& around_;
  const Gripper& gripper_;
  const GraspOptions& options_;
  GraspTarget target_;
  GraspJudge judge_;
  std::vector<ClosingLine> lines_;
  double widest_;  ///< object that fits between the fingers [m]
};

}  // namespace symscene
