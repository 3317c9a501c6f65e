#include "pick_checks.hpp"

#include <limits>
#include <memory>
#include <vector>

#include "grasping/gripper_boxes.hpp"
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
  pose.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), along).matrix();
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

/// What the arm moves: capsules of links, and in place of the tip link's the open gripper.
std::vector<LinkShape> arm_shapes(const Robot& robot, const RobotArm& arm, const Gripper& gripper) {
  std::vector<LinkShape> shapes;
  const RobotModel& model = robot.model;
  const std::size_t first = model.joints[model.joint_of_position(arm.arm.positions.front())].child;
  for (std::size_t link = 0; link < model.links.size(); ++link) {
    if (!is_carried_by(model, link, first) || is_carried_by(model, link, arm.arm.tip_link))
      continue;
    for (const Capsule& capsule : model.links[link].capsules)
      shapes.push_back(capsule_shape(link, capsule));
  }
  for (const Eigen::AlignedBox3d& box : gripper_boxes(gripper, gripper.max_opening))
    shapes.push_back(box_shape(arm.arm.tip_link, arm.T_tip_tool(gripper), box));
  return shapes;
}

class MeshCheck {
 public:
  MeshCheck(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
            const Tabletop& tabletop)
      : robot_(robot), arm_(arm), gripper_(gripper), shapes_(arm_shapes(robot, arm, gripper)) {
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

  /// The object with a vertex nearest to the tool.
  std::size_t object_at(const Eigen::VectorXd& positions) const {
    const Eigen::Isometry3d T_world_tool =
        robot_.T_world_base * poses(positions)[arm_.arm.tip_link] * arm_.T_tip_tool(gripper_);
    const Eigen::RowVector3f tool = T_world_tool.translation().cast<float>().transpose();
    std::size_t nearest = 0;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      const float distance = (meshes_[i].vertices.rowwise() - tool).rowwise().norm().minCoeff();
      if (distance >= least) continue;
      least = distance;
      nearest = i;
    }
    return nearest;
  }

 private:
  std::vector<Eigen::Isometry3d> poses(const Eigen::VectorXd& positions) const {
    return link_poses(robot_.model, with_arm_positions(arm_.arm, positions, robot_.home));
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
                      const Gripper& gripper, [[maybe_unused]] const Tabletop& tabletop,
                      const PickOptions& options) {
  PickChecks checks;
  check_limits(motion.to_pre_grasp, robot.model, arm.arm, options.speed, checks);
  const double slow = options.speed * options.line_speed;
  check_limits(motion.approach, robot.model, arm.arm, slow, checks);
  check_limits(motion.retreat, robot.model, arm.arm, slow, checks);
#ifdef SYMSCENE_HAS_FCL
  constexpr std::size_t no_target = std::numeric_limits<std::size_t>::max();
  MeshCheck meshes(robot, arm, gripper, tabletop);
  const std::size_t target =
      meshes.object_at(motion.approach.at(motion.approach.duration()).position);
  checks.objects = meshes.violations(motion.to_pre_grasp, no_target) +
                   meshes.violations(motion.approach, target);
#else
  static_cast<void>(gripper);
#endif
  return checks;
}

}  // namespace symscene::bench
