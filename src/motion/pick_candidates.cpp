#include "pick_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/retreat.hpp"
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

std::optional<RobotContact> first_contact(const ArmCollision& arm,
                                          const std::vector<Eigen::VectorXd>& way,
                                          const IgnoredObstacles& ignored) {
  RobotContact met;
  for (std::size_t i = 1; i < way.size(); ++i) {
    if (!arm.is_free(way[i - 1], way[i], ignored, &met)) return met;
  }
  return std::nullopt;
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

std::vector<HandPositions> PickCandidates::positions(const Grasp& grasp, RejectedPick& why) const {
  why.reason = PickRejection::too_far;
  std::vector<HandPositions> all;
  add_positions(grasp.T_world_tool, false, all, why);
  if (gripper_.kind == GripperKind::parallel) {
    const Eigen::Isometry3d turned(grasp.T_world_tool *
                                   Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitZ()));
    add_positions(turned, true, all, why);
  }
  const Eigen::VectorXd start = arm_positions(arm_.arm, start_);
  const auto way = [&](const HandPositions& hand) {
    return space_.difference(start, hand.positions).norm();
  };
  std::stable_sort(all.begin(), all.end(),
                   [&](const HandPositions& a, const HandPositions& b) { return way(a) < way(b); });
  return all;
}

void PickCandidates::add_positions(const Eigen::Isometry3d& T_world_tool, bool is_turned,
                                   std::vector<HandPositions>& all, RejectedPick& why) const {
  const Eigen::Isometry3d target = T_base_tip(T_world_tool);
  const std::vector<Eigen::VectorXd> solutions =
      inverse_kinematics_solutions(chain_, target, arm_positions(arm_.arm, start_),
                                   static_cast<std::size_t>(options_.solutions));
  if (solutions.empty()) return keep_latest(why, reason_unreachable(target));
  for (const Eigen::VectorXd& positions : solutions)
    all.push_back({T_world_tool, is_turned, positions});
}

PickRejection PickCandidates::reason_unreachable(const Eigen::Isometry3d& T_base_tip) const {
  if (chain_.distance_to(T_base_tip.translation()) > chain_.length()) return PickRejection::too_far;
  InverseKinematicsOptions unlimited;
  unlimited.limits = false;
  return inverse_kinematics(chain_, T_base_tip, unlimited).converged() ? PickRejection::joint_limit
                                                                       : PickRejection::unreachable;
}

Eigen::Isometry3d PickCandidates::T_base_tip(const Eigen::Isometry3d& T_world_tool) const {
  return T_world_base_.inverse() * T_world_tool * arm_.T_tip_tool(gripper_).inverse();
}

std::vector<Eigen::Vector3d> PickCandidates::retreat_directions(
    const Eigen::Isometry3d& T_world_tool) const {
  const Eigen::Vector3d approach = T_world_tool.linear().col(2);
  if (!scene_.table) return {-approach};
  const Eigen::Vector3d up = scene_.table->normal;
  if (!retreats_backwards(approach, scene_.table)) return {up};
  return {-approach, up};
}

const std::vector<Eigen::Vector3f>& PickCandidates::surface_of(std::size_t object) {
  const auto [known, is_new] = surfaces_.try_emplace(object);
  if (is_new) known->second = surface_points(scene_.objects[object], held_spacing);
  return known->second;
}

ArmCollision PickCandidates::holding_arm(const Grasp& grasp, const HandPositions& at_grasp) {
  ArmCollision arm(robot_, arm_, &gripper_, grasp.opening, obstacles_, start_, options_.collision);
  if (grasp.object < 0 || static_cast<std::size_t>(grasp.object) >= scene_.objects.size())
    return arm;
  std::vector<Eigen::Vector3f> points = surface_of(static_cast<std::size_t>(grasp.object));
  const Eigen::Isometry3f T_tool_world = at_grasp.T_world_tool.inverse().cast<float>();
  for (Eigen::Vector3f& point : points) point = T_tool_world * point;
  arm.hold(one_per_cube(points, held_spacing));
  arm.allow_contacts_at(at_grasp.positions, {grasp.object, grasp.object});
  return arm;
}

std::optional<std::vector<Eigen::VectorXd>> PickCandidates::line(
    const HandPositions& from, const Eigen::Vector3d& offset_world) const {
  return straight_way(chain_, space_, from.positions, T_base_tip(from.T_world_tool),
                      T_world_base_.linear().transpose() * offset_world,
                      {options_.line_step, options_.max_jump});
}

std::optional<PickCandidate> PickCandidates::candidate(const Grasp& grasp,
                                                       const HandPositions& at_grasp,
                                                       const ArmCollision& holding,
                                                       RejectedPick& why) const {
  const IgnoredObstacles with_target{grasp.object, grasp.object};
  const IgnoredObstacles at_target{-1, grasp.object};
  const auto collides = [&](const std::optional<RobotContact>& met) {
    if (met) keep_latest(why, PickRejection::collision, describe(*met));
    return met.has_value();
  };
  const auto straight = [&](const Eigen::Vector3d& offset) {
    auto way = line(at_grasp, offset);
    if (!way) keep_latest(why, PickRejection::line);
    return way;
  };
  const Eigen::Isometry3d& T_world_tool = at_grasp.T_world_tool;
  // The cheapest checks first: most candidates that fail do so where the arm grasps.
  if (collides(open_.contact(at_grasp.positions, with_target))) return std::nullopt;
  auto approach = straight(-gripper_.approach_distance * T_world_tool.linear().col(2));
  if (!approach) return std::nullopt;
  std::reverse(approach->begin(), approach->end());
  if (collides(open_.contact(approach->front(), at_target)) ||
      collides(first_contact(open_, *approach, with_target)))
    return std::nullopt;
  for (const Eigen::Vector3d& direction : retreat_directions(T_world_tool)) {
    auto retreat = straight(gripper_.retreat_distance * direction);
    if (retreat && !collides(first_contact(holding, *retreat, with_target)))
      return PickCandidate{std::move(*approach), std::move(*retreat)};
  }
  return std::nullopt;
}

}  // namespace symscene
