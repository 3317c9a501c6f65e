#include <numbers>

#include <fmt/format.h>

#include "core/parallel.hpp"
#include "symscene/core/error.hpp"
#include "symscene/robots/reachability.hpp"

namespace symscene {
namespace {

using Rotations = std::vector<Eigen::Matrix3d>;

Rotations rotations_from_above(int count) {
  Rotations rotations;
  for (int i = 0; i < count; ++i) {
    const double angle = std::numbers::pi * i / count;
    const Eigen::Vector3d closing(std::cos(angle), std::sin(angle), 0.0);
    rotations.push_back(tool_axes(closing, -Eigen::Vector3d::UnitZ()));
  }
  return rotations;
}

Rotations rotations_from_side(int count) {
  Rotations rotations;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    const Eigen::Vector3d approach(std::cos(angle), std::sin(angle), 0.0);
    rotations.push_back(tool_axes(Eigen::Vector3d::UnitZ().cross(approach), approach));
  }
  return rotations;
}

/// Tests points for one arm.
class PointReach {
 public:
  PointReach(const Robot& robot, const RobotArm& arm, const Gripper& gripper, int starts)
      : chain_(arm_chain(robot.model, arm.arm)),
        reference_(arm_positions(arm.arm, robot.home)),
        T_base_world_((robot.T_world_base * link_poses(robot.model, robot.home)[arm.arm.base_link])
                          .inverse()) {
    const Eigen::Translation3d tips(0.0, 0.0, gripper.finger_depth);
    T_tips_tip_ = (arm.T_tip_tool(gripper) * tips).inverse();
    options_.max_starts = starts;
    options_.refinements = 0;
  }

  float share(const Rotations& rotations, const Eigen::Vector3d& point_world) const {
    int reached = 0;
    for (const Eigen::Matrix3d& R : rotations) {
      const Eigen::AngleAxisd half_turn(std::numbers::pi, Eigen::Vector3d::UnitZ());
      if (reaches(R, point_world) || reaches(R * half_turn, point_world)) ++reached;
    }
    return static_cast<float>(reached) / static_cast<float>(rotations.size());
  }

 private:
  bool reaches(const Eigen::Matrix3d& R_world_tool, const Eigen::Vector3d& point_world) const {
    Eigen::Isometry3d T_world_tips(Eigen::Translation3d{point_world});
    T_world_tips.linear() = R_world_tool;
    const Eigen::Isometry3d T_base_tip = T_base_world_ * T_world_tips * T_tips_tip_;
    return chain_.distance_to(T_base_tip.translation()) <= chain_.length() &&
           inverse_kinematics(chain_, T_base_tip, reference_, options_).converged();
  }

  ArmChain chain_;
  Eigen::VectorXd reference_;
  Eigen::Isometry3d T_base_world_;
  Eigen::Isometry3d T_tips_tip_;
  InverseKinematicsOptions options_;
};

ReachabilityMap empty_map(const Eigen::AlignedBox3d& volume, double spacing) {
  if (volume.isEmpty() || !volume.min().allFinite() || !volume.max().allFinite())
    throw InputError("volume", "a box of finite numbers", "another");
  ReachabilityMap map;
  map.spacing = spacing;
  // Rounding must not cost the last point of an extent that is a multiple of the spacing.
  const Eigen::Array3d steps = (volume.sizes().array() / spacing + 1e-9).floor();
  if ((steps + 1.0).prod() > 1e6)
    throw InputError("volume", "a grid of at most 1000000 points",
                     fmt::format("{:g}", (steps + 1.0).prod()));
  for (std::size_t i = 0; i < 3; ++i)
    map.size[i] = static_cast<int>(steps[static_cast<Eigen::Index>(i)]) + 1;
  map.first_world = volume.center() - 0.5 * spacing * steps.matrix();
  return map;
}

}  // namespace

std::size_t ReachabilityMap::index(int x, int y, int z) const {
  return static_cast<std::size_t>(x) +
         static_cast<std::size_t>(size[0]) *
             (static_cast<std::size_t>(y) +
              static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(z));
}

Eigen::Vector3d ReachabilityMap::point_world(int x, int y, int z) const {
  return first_world + spacing * Eigen::Vector3d(x, y, z);
}

ReachabilityMap reachability_map(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                                 const Eigen::AlignedBox3d& volume_world,
                                 const ReachabilityOptions& options) {
  options.validate();
  ReachabilityMap map = empty_map(volume_world, options.spacing);
  const PointReach reach(robot, arm, gripper, options.starts);
  const Rotations above = rotations_from_above(options.directions);
  const Rotations side = rotations_from_side(options.directions);
  const std::size_t count = map.index(0, 0, map.size[2]);
  map.from_above.resize(count);
  map.from_side.resize(count);
  parallel_for_each(count, [&](std::size_t i) {
    const auto nx = static_cast<std::size_t>(map.size[0]);
    const auto ny = static_cast<std::size_t>(map.size[1]);
    const Eigen::Vector3d point = map.point_world(
        static_cast<int>(i % nx), static_cast<int>(i / nx % ny), static_cast<int>(i / nx / ny));
    map.from_above[i] = reach.share(above, point);
    map.from_side[i] = reach.share(side, point);
  });
  return map;
}

}  // namespace symscene
