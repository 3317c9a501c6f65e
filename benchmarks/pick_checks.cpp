#include "pick_checks.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "core/surface_sampling.hpp"
#include "grasping/gripper_boxes.hpp"
#include "symscene/core/geometry.hpp"
#include "symscene/motion/joint_space.hpp"

#ifdef SYMSCENE_HAS_FCL
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/narrowphase/collision.h>
#endif

namespace symscene::bench {
namespace {

constexpr double period = 0.001;   // [s]
constexpr double rounding = 1e-6;  // relative

void check_limits(const TimedPath& motion, const RobotModel& model, const Arm& arm, double speed,
                  PickChecks& checks) {
  const MotionLimits limits = motion_limits(model, arm, speed);
  const JointSpace space = joint_space(model, arm);
  for (const JointState& state : sampled(motion, period)) {
    ++checks.states;
    const auto exceeds = [](const Eigen::VectorXd& values, const Eigen::VectorXd& most) {
      return (values.cwiseAbs().array() > (1.0 + rounding) * most.array()).any();
    };
    checks.positions += space.joint_outside(state.position) >= 0 ? 1 : 0;
    checks.velocities += exceeds(state.velocity, limits.velocity) ? 1 : 0;
    checks.accelerations += exceeds(state.acceleration, limits.acceleration) ? 1 : 0;
  }
}

#ifdef SYMSCENE_HAS_FCL

constexpr std::size_t no_object = std::numeric_limits<std::size_t>::max();
constexpr std::size_t surface_samples = 5000;  // per object

using FclMesh = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<FclMesh> fcl_mesh(const TriangleMesh& mesh) {
  std::vector<fcl::Vector3d> vertices;
  std::vector<fcl::Triangle> triangles;
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i)
    vertices.emplace_back(mesh.vertices.row(i).transpose().cast<double>());
  for (Eigen::Index i = 0; i < mesh.triangles.rows(); ++i)
    triangles.emplace_back(mesh.triangles(i, 0), mesh.triangles(i, 1), mesh.triangles(i, 2));
  auto model = std::make_shared<FclMesh>();
  model->beginModel();
  model->addSubModel(vertices, triangles);
  model->endModel();
  return model;
}

/// A shape that moves with a link.
struct LinkShape {
  std::size_t link;
  Eigen::Isometry3d T_link_shape;
  std::unique_ptr<fcl::CollisionObjectd> shape;
};

LinkShape capsule_shape(std::size_t link, const Capsule& capsule) {
  const Eigen::Vector3d along = capsule.end - capsule.begin;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = symscene::shortest_rotation(Eigen::Vector3d::UnitZ(), along);
  pose.translation() = 0.5 * (capsule.begin + capsule.end);
  return {link, pose,
          std::make_unique<fcl::CollisionObjectd>(
              std::make_shared<fcl::Capsuled>(capsule.radius, along.norm()))};
}

LinkShape box_shape(std::size_t link, const Eigen::Isometry3d& T_link_tool,
                    const Eigen::AlignedBox3d& box) {
  Eigen::Isometry3d pose = T_link_tool;
  pose.translate(box.center());
  return {link, pose,
          std::make_unique<fcl::CollisionObjectd>(std::make_shared<fcl::Boxd>(box.sizes()))};
}

bool is_carried_by(const RobotModel& model, std::size_t link, std::size_t carrier) {
  while (link > carrier) link = model.joints[link - 1].parent;
  return link == carrier;
}

/// What the arm moves: capsules of links, and in place of the tip link's the gripper.
std::vector<LinkShape> arm_shapes(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                                  double opening) {
  std::vector<LinkShape> shapes;
  const RobotModel& model = robot.model;
  const std::size_t first = model.joints[model.joint_of_position(arm.arm.positions.front())].child;
  for (std::size_t link = 0; link < model.links.size(); ++link) {
    if (!is_carried_by(model, link, first) || is_carried_by(model, link, arm.arm.tip_link))
      continue;
    for (const Capsule& capsule : model.links[link].capsules)
      shapes.push_back(capsule_shape(link, capsule));
  }
  for (const Eigen::AlignedBox3d& box : gripper_boxes(gripper, opening))
    shapes.push_back(box_shape(arm.arm.tip_link, arm.T_tip_tool(gripper), box));
  return shapes;
}

class MeshCheck {
 public:
  MeshCheck(const Robot& robot, const RobotArm& arm, const Gripper& gripper, double opening,
            const Tabletop& tabletop)
      : robot_(robot),
        arm_(arm),
        gripper_(gripper),
        shapes_(arm_shapes(robot, arm, gripper, opening)) {
    for (const PlacedObject& placed : tabletop.objects) {
      meshes_.push_back(world_mesh(placed));
      objects_.emplace_back(fcl_mesh(meshes_.back()));
    }
  }

  /// The states of a motion in which the arm meets an object other than `target`.
  std::size_t violations(const TimedPath& motion, std::size_t target) {
    std::size_t count = 0;
    for (const JointState& state : sampled(motion, period))
      count += meets_object(state.position, target) ? 1 : 0;
    return count;
  }

  /// The states of a motion in which object `held`, which moves with the tool from its beginning,
  /// meets another one that it does not touch there.
  std::size_t held_violations(const TimedPath& motion, std::size_t held) {
    const Eigen::Isometry3d T_tool_world = T_world_tool(motion.at(0.0).position).inverse();
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      if (i != held && !objects_meet(held, i)) others.push_back(i);
    }
    std::size_t count = 0;
    for (const JointState& state : sampled(motion, period)) {
      objects_[held].setTransform(T_world_tool(state.position) * T_tool_world);
      objects_[held].computeAABB();
      count += std::any_of(others.begin(), others.end(),
                           [&](std::size_t i) { return objects_meet(held, i); })
                   ? 1
                   : 0;
    }
    return count;
  }

  /// The object with most of its surface between the open fingers; `no_object` if none is there.
  std::size_t object_between_fingers(const Eigen::VectorXd& positions) const {
    const Eigen::Isometry3d T_tool_world = T_world_tool(positions).inverse();
    const Eigen::AlignedBox3d between = box_between_fingers(gripper_, gripper_.max_opening);
    std::size_t held = no_object, most = 0;
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      const PointCloud points = sample_surface(meshes_[i], surface_samples);
      std::size_t inside = 0;
      for (Index k = 0; k < points.size(); ++k)
        inside += between.contains(T_tool_world * points.position(k).cast<double>()) ? 1 : 0;
      if (inside <= most) continue;
      most = inside;
      held = i;
    }
    return held;
  }

 private:
  std::vector<Eigen::Isometry3d> poses(const Eigen::VectorXd& positions) const {
    return link_poses(robot_.model, with_arm_positions(arm_.arm, positions, robot_.home));
  }

  Eigen::Isometry3d T_world_tool(const Eigen::VectorXd& positions) const {
    return robot_.T_world_base * poses(positions)[arm_.arm.tip_link] * arm_.T_tip_tool(gripper_);
  }

  bool objects_meet(std::size_t a, std::size_t b) const {
    if (!objects_[a].getAABB().overlap(objects_[b].getAABB())) return false;
    fcl::CollisionResultd result;
    return fcl::collide(&objects_[a], &objects_[b], fcl::CollisionRequestd(), result) > 0;
  }

  bool meets_object(const Eigen::VectorXd& positions, std::size_t target) {
    const std::vector<Eigen::Isometry3d> at = poses(positions);
    for (LinkShape& part : shapes_) {
      part.shape->setTransform(robot_.T_world_base * at[part.link] * part.T_link_shape);
      part.shape->computeAABB();
      for (std::size_t i = 0; i < objects_.size(); ++i) {
        if (i == target || !part.shape->getAABB().overlap(objects_[i].getAABB())) continue;
        fcl::CollisionResultd result;
        if (fcl::collide(part.shape.get(), &objects_[i], fcl::CollisionRequestd(), result) > 0)
          return true;
      }
    }
    return false;
  }

  const Robot& robot_;
  const RobotArm& arm_;
  const Gripper& gripper_;
  std::vector<LinkShape> shapes_;
  std::vector<TriangleMesh> meshes_;
  std::vector<fcl::CollisionObjectd> objects_;
};

#endif

}  // namespace

PickChecks& PickChecks::operator+=(const PickChecks& other) {
  states += other.states;
  positions += other.positions;
  velocities += other.velocities;
  accelerations += other.accelerations;
  objects += other.objects;
  held += other.held;
  return *this;
}

bool checks_meshes() {
#ifdef SYMSCENE_HAS_FCL
  return true;
#else
  return false;
#endif
}

PickChecks check_pick(const PickMotion& motion, const Robot& robot, const RobotArm& arm,
                      const Gripper& gripper, [[maybe_unused]] double opening,
                      [[maybe_unused]] const Tabletop& tabletop, const PickOptions& options) {
  PickChecks checks;
  check_limits(motion.to_pre_grasp, robot.model, arm.arm, options.speed, checks);
  const double slow = options.speed * options.line_speed;
  check_limits(motion.approach, robot.model, arm.arm, slow, checks);
  check_limits(motion.retreat, robot.model, arm.arm, slow, checks);
#ifdef SYMSCENE_HAS_FCL
  MeshCheck open(robot, arm, gripper, gripper.max_opening, tabletop);
  MeshCheck closed(robot, arm, gripper, opening, tabletop);
  const std::size_t target =
      open.object_between_fingers(motion.approach.at(motion.approach.duration()).position);
  checks.objects = open.violations(motion.to_pre_grasp, no_object) +
                   open.violations(motion.approach, target) +
                   closed.violations(motion.retreat, target);
  if (target != no_object) checks.held = closed.held_violations(motion.retreat, target);
#else
  static_cast<void>(gripper);
#endif
  return checks;
}

}  // namespace symscene::bench
