#include "robots/robot_solids.hpp"

#include "core/joined_meshes.hpp"
#include "robots/solid_mesh.hpp"

namespace symscene {
namespace {

/// A finger of the closed hand on the side of positive y, in the tool frame. Its pad is at y = 0.
TriangleMesh finger_mesh(const Gripper& gripper, double side) {
  const double thick = 0.5 * (gripper.finger_thickness + gripper.tip_thickness);
  const double x = 0.5 * gripper.finger_width;
  Eigen::AlignedBox3d box(Eigen::Vector3d(-x, 0.0, 0.0));
  box.extend(Eigen::Vector3d(x, side * thick, gripper.finger_depth));
  return box_mesh(box);
}

TriangleMesh palm_mesh(const Gripper& gripper) {
  const Eigen::Vector3d& size = gripper.palm_size;
  return box_mesh({Eigen::Vector3d(-0.5 * size.x(), -0.5 * size.y(), -size.z()),
                   Eigen::Vector3d(0.5 * size.x(), 0.5 * size.y(), 0.0)});
}

}  // namespace

RobotSolids::RobotSolids(const Robot& robot, const RobotArm& arm, const Gripper& gripper)
    : robot_(robot), T_tip_tool_(arm.T_tip_tool(gripper)), tip_link_(arm.arm.tip_link) {
  for (std::size_t i = 0; i < robot.model.links.size(); ++i) {
    const Link& link = robot.model.links[i];
    if (link.capsules.empty()) continue;
    std::vector<TriangleMesh> parts;
    for (const Capsule& capsule : link.capsules) parts.push_back(capsule_mesh(capsule));
    links_.push_back(i);
    solids_.push_back({link.name, joined(parts), false});
  }
  solids_.push_back({"palm", palm_mesh(gripper), true});
  solids_.push_back({"left finger", finger_mesh(gripper, 1.0), true});
  solids_.push_back({"right finger", finger_mesh(gripper, -1.0), true});
}

std::vector<Eigen::Isometry3d> RobotSolids::poses(const RobotState& state) const {
  const std::vector<Eigen::Isometry3d> links = link_poses(robot_.model, state.positions);
  std::vector<Eigen::Isometry3d> poses;
  for (const std::size_t i : links_) poses.push_back(robot_.T_world_base * links[i]);
  const Eigen::Isometry3d T_world_tool = robot_.T_world_base * links[tip_link_] * T_tip_tool_;
  poses.push_back(T_world_tool);
  for (const double side : {0.5, -0.5})
    poses.push_back(T_world_tool * Eigen::Translation3d(0.0, side * state.opening, 0.0));
  return poses;
}

Eigen::Isometry3d RobotSolids::tool(const RobotState& state) const {
  return robot_.T_world_base * link_poses(robot_.model, state.positions)[tip_link_] * T_tip_tool_;
}

}  // namespace symscene
