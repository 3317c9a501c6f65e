#include "arm_bodies.hpp"

#include <algorithm>
#include <cmath>

#include "grasping/gripper_boxes.hpp"
#include "symscene/core/types.hpp"

namespace symscene {
namespace {

/// The joints that carry a link, the nearest first.
std::vector<std::size_t> joints_above(const RobotModel& model, std::size_t link) {
  std::vector<std::size_t> above;
  for (; link != 0; link = model.joints[link - 1].parent) above.push_back(link - 1);
  return above;
}

bool is_carried_by(const RobotModel& model, std::size_t link, std::size_t carrier) {
  while (link > carrier) link = model.joints[link - 1].parent;
  return link == carrier;
}

/// The joints of the arm that move a link, in the order of the chain.
std::vector<std::size_t> moving_above(const RobotModel& model, const Arm& arm, std::size_t link) {
  std::vector<std::size_t> moving;
  for (const std::size_t joint : joints_above(model, link)) {
    const auto position = model.joints[joint].position;
    if (position &&
        std::find(arm.positions.begin(), arm.positions.end(), *position) != arm.positions.end())
      moving.push_back(joint);
  }
  std::reverse(moving.begin(), moving.end());
  return moving;
}

double travel(const Joint& joint) {
  if (joint.kind != JointKind::prismatic) return 0.0;
  return std::max(std::abs(joint.limits.lower), std::abs(joint.limits.upper));
}

double extent_of(const std::vector<Capsule>& capsules) {
  double extent = 0.0;
  for (const Capsule& capsule : capsules)
    extent = std::max(extent, std::max(capsule.begin.norm(), capsule.end.norm()) + capsule.radius);
  return extent;
}

/// A measured table is not perpendicular to an axis on which a robot stands upright.
constexpr double vertical_tolerance = radians(5.0);

/// Whether a joint that no joint before it moves turns about the vertical.
bool turns_about(const RobotModel& model, std::size_t joint, const Eigen::Vector3d& up) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  for (const std::size_t above : joints_above(model, model.joints[joint].child)) {
    if (above != joint && model.joints[above].kind != JointKind::fixed) return false;
    turn = model.joints[above].T_parent_joint.linear() * turn;
  }
  return std::abs((turn * model.joints[joint].axis).dot(up)) > std::cos(vertical_tolerance);
}

/// Whether some motion of the arm changes a link's height.
bool changes_height(const RobotModel& model, const Arm& arm, std::size_t link,
                    const Eigen::Vector3d& up) {
  const std::vector<std::size_t> moving = moving_above(model, arm, link);
  if (moving.size() != 1) return !moving.empty();
  return model.joints[moving[0]].kind == JointKind::prismatic || !turns_about(model, moving[0], up);
}

/// A capsule around a box.
Capsule around(const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d half = 0.5 * box.sizes();
  Eigen::Index longest = 0;
  half.maxCoeff(&longest);
  const Eigen::Vector3d along = half[longest] * Eigen::Vector3d::Unit(longest);
  return {box.center() - along, box.center() + along, (half - along).norm()};
}

ArmBody gripper_body(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                     double opening, const Eigen::Isometry3d& T_tip_tool) {
  ArmBody body;
  body.name = "gripper";
  body.link = arm.arm.tip_link;
  body.boxes = gripper_boxes(gripper, opening);
  for (const Eigen::AlignedBox3d& box : body.boxes) {
    const Capsule capsule = around(box);
    body.capsules.push_back({T_tip_tool * capsule.begin, T_tip_tool * capsule.end, capsule.radius});
  }
  body.moves = true;
  body.can_meet_table = true;
  body.motion = greatest_motion(robot.model, arm.arm, arm.arm.tip_link, extent_of(body.capsules));
  return body;
}

/// Whether a link is one of the two bodies before the gripper, on which it is mounted.
bool carries_gripper(const RobotModel& model, const Arm& arm, std::size_t link,
                     const std::vector<std::size_t>& rigid) {
  std::size_t body = rigid[arm.tip_link];
  for (int i = 0; i < 2; ++i) {
    if (rigid[link] == body) return true;
    if (body == 0) return false;
    body = rigid[model.joints[body - 1].parent];
  }
  return false;
}

void add_pairs(const RobotModel& model, const Arm& arm, bool has_gripper, ArmBodies& all) {
  const std::vector<std::size_t> rigid = rigid_bodies(model);
  for (std::size_t a = 0; a < all.bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < all.bodies.size(); ++b) {
      if (!all.bodies[a].moves && !all.bodies[b].moves) continue;
      const bool is_hand = has_gripper && b + 1 == all.bodies.size();
      const bool is_excluded =
          is_hand ? carries_gripper(model, arm, all.bodies[a].link, rigid)
                  : ignores_collision(model, all.bodies[a].link, all.bodies[b].link);
      if (!is_excluded) all.pairs.push_back({a, b});
    }
  }
}

}  // namespace

Eigen::VectorXd greatest_motion(const RobotModel& model, const Arm& arm, std::size_t link,
                                double extent) {
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(arm.positions.size()));
  double reach = extent;  // of the points from the joint's axis, in any configuration
  for (const std::size_t i : joints_above(model, link)) {
    const Joint& joint = model.joints[i];
    const auto found = joint.position
                           ? std::find(arm.positions.begin(), arm.positions.end(), *joint.position)
                           : arm.positions.end();
    reach += travel(joint);
    if (found != arm.positions.end())
      motion[found - arm.positions.begin()] = joint.kind == JointKind::prismatic ? 1.0 : reach;
    reach += joint.T_parent_joint.translation().norm();
  }
  return motion;
}

ArmBodies arm_bodies(const Robot& robot, const RobotArm& arm, const Gripper* gripper,
                     double opening, const Eigen::Vector3d& up) {
  const RobotModel& model = robot.model;
  ArmBodies all;
  all.T_tip_tool = arm.T_tip_wrist;
  if (gripper != nullptr) all.T_tip_tool = arm.T_tip_tool(*gripper);
  for (std::size_t link = 0; link < model.links.size(); ++link) {
    const bool is_replaced = gripper != nullptr && is_carried_by(model, link, arm.arm.tip_link);
    if (model.links[link].capsules.empty() || is_replaced) continue;
    ArmBody body;
    body.name = model.links[link].name;
    body.link = link;
    body.capsules = model.links[link].capsules;
    body.moves = !moving_above(model, arm.arm, link).empty();
    body.can_meet_table = changes_height(model, arm.arm, link, up);
    body.motion = greatest_motion(model, arm.arm, link, extent_of(body.capsules));
    all.bodies.push_back(body);
  }
  if (gripper != nullptr)
    all.bodies.push_back(gripper_body(robot, arm, *gripper, opening, all.T_tip_tool));
  add_pairs(model, arm.arm, gripper != nullptr, all);
  return all;
}

}  // namespace symscene
