#include "symscene/motion/arm_collision.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "arm_bodies.hpp"
#include "held_object.hpp"
#include "segment_distance.hpp"

namespace symscene {
namespace {

/// A body or a pair is this far from what it may not meet.
constexpr double unbounded = 1e3;
/// Parts may come this much nearer than their bound between configurations that are looked at; of a
/// held object, whose completed surface is not known as well, more. [m]
constexpr double link_step = 0.0005, held_step = 0.002;

std::string name_of(const RobotContact& contact) {
  switch (contact.other.kind) {
    case ObstacleKind::object:
      return fmt::format("object {}", contact.other.object);
    case ObstacleKind::surface:
      return "a surface that belongs to no object";
    case ObstacleKind::never_seen:
      return "space that was never seen";
    case ObstacleKind::table:
      return "the table";
    case ObstacleKind::robot:
      return contact.other_link;
  }
  return "";
}

}  // namespace

std::string describe(const RobotContact& contact) {
  const double millimetres = 1e3 * contact.other.distance;
  if (millimetres < 0.0)
    return fmt::format("{} meets {} by {:.0f} mm", contact.part, name_of(contact), -millimetres);
  return fmt::format("{} is {:.1f} mm from {} ({:.1f} mm required)", contact.part, millimetres,
                     name_of(contact), 1e3 * contact.bound);
}

/// The robot at one configuration is a vector of poses in the world; checks go through its bodies.
struct ArmCollision::Model {
  const Robot& robot;
  const RobotArm& arm;
  const MotionObstacles& obstacles;
  Eigen::VectorXd positions;
  ArmCollisionOptions options;
  ArmBodies parts;
  HeldObject held = {};
  double held_bound = options.held_clearance;
  Eigen::VectorXd held_motion = {};

  using Poses = std::vector<Eigen::Isometry3d>;

  /// What a check finds: the first contact, and how far the motion may go on.
  struct Finding {
    std::optional<RobotContact> contact;
    double advance = 0.0;  ///< share of the motion that surely meets nothing
  };

  Poses poses(const Eigen::VectorXd& arm_positions) const {
    Poses all = link_poses(robot.model, with_arm_positions(arm.arm, arm_positions, positions));
    for (Eigen::Isometry3d& pose : all) pose = robot.T_world_base * pose;
    return all;
  }

  /// `way`: absolute change of the joints in the motion; zero to check one configuration.
  Finding check(const Eigen::VectorXd& arm_positions, const Eigen::VectorXd& way,
                const IgnoredObstacles& ignored) const {
    const Poses at = poses(arm_positions);
    Finding finding;
    finding.advance = 1.0;
    for (const ArmBody& body : parts.bodies) {
      if (body.moves &&
          !admit(scene_contact(body, at[body.link], ignored), body.motion.dot(way), finding))
        return finding;
    }
    for (const BodyPair& pair : parts.pairs) {
      const ArmBody& a = parts.bodies[pair.a];
      const ArmBody& b = parts.bodies[pair.b];
      if (!admit(mutual_contact(a, b, at), (a.motion + b.motion).dot(way), finding)) return finding;
    }
    if (!held.empty()) admit(held_contact(at, ignored), held_motion.dot(way), finding, held_step);
    return finding;
  }

  /// Lowers the advance by what a part allows; false and a contact if it is too near already.
  static bool admit(const RobotContact& nearest, double motion, Finding& finding,
                    double least_step = link_step) {
    if (nearest.other.distance < nearest.bound) {
      finding.contact = nearest;
      return false;
    }
    // Between configurations that are looked at, a part may come a little nearer than the bound, or
    // else a motion along it would not advance.
    const double share = nearest.bound > 0.0 ? 0.5 : 0.25;
    const double nearer = std::max(least_step, share * std::abs(nearest.bound));
    const double free = nearest.other.distance - nearest.bound + nearer;
    if (motion > 0.0) finding.advance = std::min(finding.advance, free / motion);
    return true;
  }

  RobotContact scene_contact(const ArmBody& body, const Eigen::Isometry3d& T_world_link,
                             const IgnoredObstacles& ignored) const {
    RobotContact contact;
    contact.part = body.name;
    contact.bound = body.boxes.empty() ? options.clearance : options.hand_clearance;
    contact.other.distance = unbounded;
    if (body.can_meet_table && obstacles.table()) take_table(body, T_world_link, contact);
    if (!body.boxes.empty()) {
      const Eigen::Isometry3d T_world_tool = T_world_link * parts.T_tip_tool;
      for (const Eigen::AlignedBox3d& box : body.boxes)
        take_box(box, T_world_tool, ignored, contact);
    } else {
      for (const Capsule& capsule : body.capsules)
        take_capsule(transformed(capsule, T_world_link), ignored, contact);
    }
    return contact;
  }

  void take_table(const ArmBody& body, const Eigen::Isometry3d& T_world_link,
                  RobotContact& contact) const {
    const Plane& table = *obstacles.table();
    const auto take = [&](double height) {
      if (height < contact.other.distance) contact.other = {height, ObstacleKind::table, -1};
    };
    if (body.boxes.empty()) {
      for (const Capsule& capsule : body.capsules) {
        take(std::min(table.signed_distance(T_world_link * capsule.begin),
                      table.signed_distance(T_world_link * capsule.end)) -
             capsule.radius);
      }
      return;
    }
    const Eigen::Isometry3d T_world_tool = T_world_link * parts.T_tip_tool;
    const Eigen::Vector3d normal = T_world_tool.linear().transpose() * table.normal;
    for (const Eigen::AlignedBox3d& box : body.boxes) {
      take(table.signed_distance(T_world_tool * box.center()) -
           normal.cwiseAbs().dot(0.5 * box.sizes()));
    }
  }

  void take(const std::optional<ObstacleDistance>& nearest, RobotContact& contact) const {
    const ObstacleDistance other = nearest.value_or(ObstacleDistance{MotionObstacles::near});
    if (other.distance < contact.other.distance) contact.other = other;
  }

  /// The field first: it is enough where nothing is near.
  void take_capsule(const Capsule& capsule, const IgnoredObstacles& ignored,
                    RobotContact& contact) const {
    constexpr double spacing = 0.03;
    const double length = (capsule.end - capsule.begin).norm();
    const double steps = std::max(1.0, std::ceil(length / spacing));
    double least = unbounded;
    for (double i = 0.0; i <= steps; i += 1.0) {
      const Eigen::Vector3d point = capsule.begin + i / steps * (capsule.end - capsule.begin);
      least = std::min(least, obstacles.bound_at(point));
    }
    least -= 0.5 * length / steps + capsule.radius;
    if (least < 0.5 * MotionObstacles::near)
      return take(obstacles.nearest(capsule, ignored), contact);
    take(ObstacleDistance{least}, contact);
  }

  void take_box(const Eigen::AlignedBox3d& box, const Eigen::Isometry3d& T_world_tool,
                const IgnoredObstacles& ignored, RobotContact& contact) const {
    const Eigen::Vector3d centre = T_world_tool * box.center();
    const double least = obstacles.bound_at(centre) - 0.5 * box.sizes().norm();
    if (least < 0.5 * MotionObstacles::near)
      return take(obstacles.nearest(box, T_world_tool, ignored), contact);
    take(ObstacleDistance{least}, contact);
  }

  RobotContact mutual_contact(const ArmBody& a, const ArmBody& b, const Poses& at) const {
    RobotContact contact{b.name, {unbounded, ObstacleKind::robot, -1}, a.name, options.clearance};
    for (const Capsule& of_a : a.capsules) {
      const Capsule first = transformed(of_a, at[a.link]);
      for (const Capsule& of_b : b.capsules) {
        contact.other.distance = std::min(contact.other.distance,
                                          capsule_distance(first, transformed(of_b, at[b.link])));
      }
    }
    return contact;
  }

  RobotContact held_contact(const Poses& at, const IgnoredObstacles& ignored) const {
    // The table may be nearer than all else by this.
    const double table_depth = held_bound + 0.8 * options.held_depth;
    RobotContact contact{"held object",
                         held.nearest(obstacles, at[arm.arm.tip_link], ignored, table_depth), "",
                         held_bound};
    if (contact.other.kind == ObstacleKind::table) {
      contact.other.distance -= table_depth;
      contact.bound -= table_depth;
    }
    return contact;
  }
};

ArmCollision::ArmCollision(const Robot& robot, const RobotArm& arm, const Gripper* gripper,
                           double opening, const MotionObstacles& obstacles,
                           const Eigen::VectorXd& positions, const ArmCollisionOptions& options) {
  options.validate();
  link_poses(robot.model, positions);  // checks their number
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  if (obstacles.table()) up = obstacles.table()->normal;
  model_.reset(new Model{
      robot, arm, obstacles, positions, options,
      arm_bodies(robot, arm, gripper, opening, robot.T_world_base.linear().transpose() * up)});
}

ArmCollision::~ArmCollision() = default;
ArmCollision::ArmCollision(ArmCollision&&) noexcept = default;

void ArmCollision::hold(const std::vector<Eigen::Vector3f>& points_tool) {
  std::vector<Eigen::Vector3d> points_tip;
  for (const Eigen::Vector3f& point : points_tool)
    points_tip.emplace_back(model_->parts.T_tip_tool * point.cast<double>());
  model_->held = HeldObject(points_tip);
  const Arm& arm = model_->arm.arm;
  model_->held_motion =
      greatest_motion(model_->robot.model, arm, arm.tip_link, model_->held.extent());
}

void ArmCollision::allow_contacts_at(const Eigen::VectorXd& arm_positions,
                                     const IgnoredObstacles& ignored) {
  const double far_from_table = unbounded;
  const Eigen::Isometry3d T_world_tip = model_->poses(arm_positions)[model_->arm.arm.tip_link];
  const double distance =
      model_->held.nearest(model_->obstacles, T_world_tip, ignored, far_from_table).distance;
  model_->held_bound =
      std::min(model_->options.held_clearance, distance - model_->options.lift_slack);
}

std::optional<RobotContact> ArmCollision::contact(const Eigen::VectorXd& arm_positions,
                                                  const IgnoredObstacles& ignored) const {
  return model_->check(arm_positions, Eigen::VectorXd::Zero(arm_positions.size()), ignored).contact;
}

bool ArmCollision::is_free(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                           const IgnoredObstacles& ignored, RobotContact* met) const {
  const Eigen::VectorXd way = (to - from).cwiseAbs();
  for (double share = 0.0;;) {
    const Model::Finding finding = model_->check(from + share * (to - from), way, ignored);
    if (finding.contact) {
      if (met != nullptr) *met = *finding.contact;
      return false;
    }
    if (share >= 1.0) return true;
    share = std::min(1.0, share + finding.advance);
  }
}

std::vector<Capsule> ArmCollision::capsules(const Eigen::VectorXd& arm_positions) const {
  const std::vector<Eigen::Isometry3d> at = model_->poses(arm_positions);
  std::vector<Capsule> all;
  for (const ArmBody& body : model_->parts.bodies) {
    for (const Capsule& capsule : body.capsules) all.push_back(transformed(capsule, at[body.link]));
  }
  return all;
}

}  // namespace symscene
