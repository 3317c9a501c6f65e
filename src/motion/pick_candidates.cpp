#include "pick_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "straight_way.hpp"
#include "surface_points.hpp"
#include "symscene/core/geometry.hpp"

namespace symscene {
namespace {

constexpr float held_spacing = 0.012F;  // of points of a held object [m]

/// Why a grasp is rejected: the reason that came latest in the order of the steps.
void keep_latest(RejectedPick& why, PickRejection reason, const std::string& detail = {}) {
  if (reason < why.reason) return;
  if (reason > why.reason || why.detail.empty()) why.detail = detail;
  why.reason = reason;
}

bool way_is_free(const ArmCollision& arm, const std::vector<Eigen::VectorXd>& way,
                 const IgnoredObstacles& ignored, RobotContact& met) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    if (!arm.is_free(way[i - 1], way[i], ignored, &met)) return false;
  }
  return true;
}

}  // namespace

PickCandidates::PickCandidates(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                               const Eigen::VectorXd& start, const GraspScene& scene,
                               const MotionObstacles& obstacles, const PickOptions& options)
    : robot_(robot),
      arm_(arm),
      gripper_(gripper),
      start_(start),
      scene_(scene),
      obstacles_(obstacles),
      options_(options),
      chain_(arm_chain(robot.model, arm.arm)),
      space_(joint_space(robot.model, arm.arm)),
      open_(robot, arm, &gripper, gripper.max_opening, obstacles, start, options.collision),
      T_world_base_(robot.T_world_base * link_poses(robot.model, start)[arm.arm.base_link]) {}

std::vector<PickCandidate> PickCandidates::find(const Grasp& grasp, RejectedPick& why) const {
  why.reason = PickRejection::too_far;
  std::vector<PickCandidate> candidates;
  add_candidates(grasp, grasp.T_world_tool, candidates, why);
  if (gripper_.kind == GripperKind::parallel) {
    const Eigen::Isometry3d turned(grasp.T_world_tool *
                                   Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitZ()));
    add_candidates(grasp, turned, candidates, why);
  }
  return candidates;
}

void PickCandidates::add_candidates(const Grasp& grasp, const Eigen::Isometry3d& T_world_tool,
                                    std::vector<PickCandidate>& candidates,
                                    RejectedPick& why) const {
  const Eigen::Isometry3d T_base_tip =
      T_world_base_.inverse() * T_world_tool * arm_.T_tip_tool(gripper_).inverse();
  const auto count = static_cast<std::size_t>(options_.solutions);
  const std::vector<Eigen::VectorXd> solutions =
      inverse_kinematics_solutions(chain_, T_base_tip, arm_positions(arm_.arm, start_), count);
  if (solutions.empty()) return keep_latest(why, reason_unreachable(T_base_tip));
  const ArmCollision holding = holding_arm(grasp, T_world_tool);
  for (const Eigen::VectorXd& at_grasp : solutions) {
    auto found = candidate(grasp, T_base_tip, at_grasp, holding, why);
    if (found) candidates.push_back(std::move(*found));
  }
}

PickRejection PickCandidates::reason_unreachable(const Eigen::Isometry3d& T_base_tip) const {
  if (chain_.distance_to(T_base_tip.translation()) > chain_.length()) return PickRejection::too_far;
  InverseKinematicsOptions unlimited;
  unlimited.limits = false;
  return inverse_kinematics(chain_, T_base_tip, unlimited).converged() ? PickRejection::joint_limit
                                                                       : PickRejection::unreachable;
}

Eigen::Vector3d PickCandidates::retreat_direction(const Eigen::Isometry3d& T_world_tool) const {
  const Eigen::Vector3d up =
      scene_.table ? scene_.table->normal : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d approach = T_world_tool.linear().col(2);
  return angle_between(approach, -up) <= backwards_tilt ? Eigen::Vector3d(-approach) : up;
}

ArmCollision PickCandidates::holding_arm(const Grasp& grasp,
                                         const Eigen::Isometry3d& T_world_tool) const {
  ArmCollision arm(robot_, arm_, &gripper_, grasp.opening, obstacles_, start_, options_.collision);
  if (grasp.object < 0 || static_cast<std::size_t>(grasp.object) >= scene_.objects.size())
    return arm;
  std::vector<Eigen::Vector3f> points =
      surface_points(scene_.objects[static_cast<std::size_t>(grasp.object)], held_spacing);
  const Eigen::Isometry3f T_tool_world = T_world_tool.inverse().cast<float>();
  for (Eigen::Vector3f& point : points) point = T_tool_world * point;
  arm.hold(one_per_cube(points, held_spacing));
  return arm;
}

std::optional<PickCandidate> PickCandidates::candidate(const Grasp& grasp,
                                                       const Eigen::Isometry3d& T_base_tip,
                                                       const Eigen::VectorXd& at_grasp,
                                                       const ArmCollision& holding,
                                                       RejectedPick& why) const {
  const IgnoredObstacles with_target{grasp.object, grasp.object};
  const IgnoredObstacles at_target{-1, grasp.object};
  const StraightWay line{options_.line_step, options_.max_jump};
  const Eigen::Isometry3d T_world_tip = T_world_base_ * T_base_tip;
  const Eigen::Isometry3d T_world_tool = T_world_tip * arm_.T_tip_tool(gripper_);
  const Eigen::Matrix3d to_base = T_world_base_.linear().transpose();
  const Eigen::Vector3d back = -gripper_.approach_distance * T_world_tool.linear().col(2);
  const Eigen::Vector3d away = gripper_.retreat_distance * retreat_direction(T_world_tool);
  auto approach = straight_way(chain_, space_, at_grasp, T_base_tip, to_base * back, line);
  auto retreat = straight_way(chain_, space_, at_grasp, T_base_tip, to_base * away, line);
  if (!approach || !retreat) {
    keep_latest(why, PickRejection::line);
    return std::nullopt;
  }
  std::reverse(approach->begin(), approach->end());
  RobotContact met;
  const auto before = open_.contact(approach->front(), at_target);
  if (before) met = *before;
  if (before || !way_is_free(open_, *approach, with_target, met) ||
      !way_is_free(holding, *retreat, with_target, met)) {
    keep_latest(why, PickRejection::collision, describe(met));
    return std::nullopt;
  }
  return PickCandidate{std::move(*approach), std::move(*retreat)};
}

}  // namespace symscene
