#include "place_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "carry_line.hpp"
#include "core/voxel_sampling.hpp"
#include "free_motion.hpp"
#include "motion/pose_following.hpp"
#include "symscene/robots/inverse_kinematics.hpp"

namespace symscene {
namespace {

constexpr double held_spacing = 0.012;  // of points of a held object [m]
constexpr int yaws = 8;

/// Points of a held object in the tool frame: corners of its completed surface, or what was
/// observed.
std::vector<Eigen::Vector3f> held_points(const GraspObject& object,
                                         const Eigen::Isometry3d& T_table_tool) {
  const TriangleMesh& mesh = object.surface.mesh;
  PointCloud cloud{mesh.vertices.rows() > 0 ? mesh.vertices : object.observed.positions, {}, {}};
  cloud = voxel_downsample(cloud, held_spacing);
  const Eigen::Isometry3f T_tool_table = T_table_tool.inverse().cast<float>();
  std::vector<Eigen::Vector3f> points;
  for (Index i = 0; i < cloud.size(); ++i) points.emplace_back(T_tool_table * cloud.position(i));
  return points;
}

Eigen::Vector3d middle_of(const std::vector<Eigen::Vector3f>& points) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& point : points) middle += point.cast<double>();
  return points.empty() ? middle : Eigen::Vector3d(middle / static_cast<double>(points.size()));
}

/// Height of a tool of that orientation above the lowest of the points that it holds and of the
/// finger tips. [m]
double height_above_lowest(const Eigen::Matrix3d& tool, const std::vector<Eigen::Vector3f>& held,
                           const Gripper& gripper) {
  double lowest = std::min(0.0, tool(2, 2) * gripper.finger_depth);
  for (const Eigen::Vector3f& point : held)
    lowest = std::min(lowest, tool.row(2).dot(point.cast<double>()));
  return -lowest;
}

/// Poses of the tool above the bin.
std::vector<Eigen::Isometry3d> poses_above(const PickBin& bin, const Eigen::Matrix3d& tool,
                                           const std::vector<Eigen::Vector3f>& held,
                                           const PickScene& in) {
  const Eigen::Vector3d middle = middle_of(held);
  std::vector<Eigen::Isometry3d> poses;
  for (int k = 0; k < yaws; ++k) {
    const Eigen::AngleAxisd turn(2.0 * std::numbers::pi * k / yaws, Eigen::Vector3d::UnitZ());
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = turn * tool;
    const Eigen::Vector2d off = (pose.linear() * middle).head<2>();
    const double height = in.bin.height + in.options.execution.drop_height +
                          height_above_lowest(pose.linear(), held, in.gripper);
    pose.translation() << bin.middle - off, height;
    poses.push_back(pose);
  }
  return poses;
}

/// Obstacles of the scene but never-seen space: the arm and the object came out of it.
MotionObstacleOptions seen_obstacles(const PickScene& in) {
  MotionObstacleOptions options = in.options.pick.obstacles;
  options.never_seen = false;
  return options;
}

/// One call of plan_place().
class PlacePlanner {
 public:
  PlacePlanner(const PickScene& in, const Eigen::VectorXd& start, const PickMotion& pick,
               const Grasp& grasp)
      : in_(in),
        from_(pick.retreat.at(pick.retreat.duration()).position),
        chain_(arm_chain(in.robot.model, in.arm.arm)),
        T_table_base_(in.robot.T_world_base *
                      link_poses(in.robot.model, start)[in.arm.arm.base_link]),
        T_tip_tool_(in.arm.T_tip_tool(in.gripper)),
        held_(held_points(in.scene.objects[static_cast<std::size_t>(grasp.object)],
                          tool_at(pick.retreat.at(0.0).position))),
        space_(joint_space(in.robot.model, in.arm.arm)),
        limits_(motion_limits(in.robot.model, in.arm.arm, in.options.pick.speed)),
        obstacles_(in.scene, {}, seen_obstacles(in)),
        collision_(in.robot, in.arm, &in.gripper, grasp.opening, obstacles_, start,
                   in.options.pick.collision),
        lifting_(in.robot, in.arm, &in.gripper, grasp.opening, obstacles_, start,
                 in.options.pick.collision),
        planner_{collision_, space_, limits_, in.options.pick.rrt, {grasp.object, grasp.object}} {
    collision_.hold(held_);
    lifting_.hold(held_);
    lifting_.allow_contacts_at(pick.retreat.at(0.0).position, planner_.ignored);
  }

  PlaceMotion plan() const {
    const Eigen::Matrix3d as_held = tool_at(from_).linear();
    const auto upright = poses_above(in_.bin, as_held, held_, in_);
    FreeMotion motion = upright_motion(upright);
    if (!motion.path) motion = any_motion(upright);
    if (!motion.path) return {std::nullopt, std::move(motion.obstacle)};
    return {slow(motion), {}};
  }

 private:
  Eigen::Isometry3d tool_at(const Eigen::VectorXd& positions) const {
    return T_table_base_ * tip_pose(chain_, positions) * T_tip_tool_;
  }
  Eigen::Isometry3d T_base_tip(const Eigen::Isometry3d& T_table_tool) const {
    return T_table_base_.inverse() * T_table_tool * T_tip_tool_.inverse();
  }

  /// A way on which the hand stays as it is after the lift, up to turns about the vertical: the
  /// weight of a tilted object turns it in the fingers. The lower ways first.
  FreeMotion upright_motion(const std::vector<Eigen::Isometry3d>& goals) const {
    for (const double raise : {0.0, 0.08, 0.16}) {
      for (const Eigen::Isometry3d& goal : goals) {
        auto way = followed(upright_line(tool_at(from_), goal,
                                         T_table_base_.translation().head<2>(), raise, line_step));
        if (way) return {timed_motion(timing(limits_), *way), {}, std::move(*way)};
      }
    }
    return {std::nullopt, "no upright way is free"};
  }

  /// Joint positions that follow poses of the tool, the first of them at `from_`; none where the
  /// joints jump, or the arm or what it holds meets something. Straight up the held object may
  /// slide along what it touches, as in the lift.
  std::optional<std::vector<Eigen::VectorXd>> followed(
      const std::vector<Eigen::Isometry3d>& poses) const {
    std::vector<Eigen::Isometry3d> T_base_tips;
    for (std::size_t k = 1; k < poses.size(); ++k) T_base_tips.push_back(T_base_tip(poses[k]));
    auto way = followed_poses(chain_, space_, from_, T_base_tips, max_jump);
    bool rises = true;
    for (std::size_t k = 1; way && k < poses.size(); ++k) {
      rises = rises && (poses[k].translation() - poses[0].translation()).head<2>().norm() < 1e-6;
      const ArmCollision& arm = rises ? lifting_ : collision_;
      if (!arm.is_free((*way)[k - 1], (*way)[k], planner_.ignored)) return std::nullopt;
    }
    return way;
  }

  FreeMotion any_motion(std::vector<Eigen::Isometry3d> poses) const {
    const Eigen::Matrix3d down = tool_pointing_down(Eigen::Vector3d::Zero(), 0.0).linear();
    for (const auto& pose : poses_above(in_.bin, down, held_, in_)) poses.push_back(pose);
    return plan_free_motion(planner_, from_, free_positions(poses));
  }

  std::vector<Eigen::VectorXd> free_positions(const std::vector<Eigen::Isometry3d>& poses) const {
    InverseKinematicsOptions search;
    search.max_starts = 8;
    std::vector<Eigen::VectorXd> free;
    for (const Eigen::Isometry3d& pose : poses) {
      for (auto& positions :
           inverse_kinematics_solutions(chain_, T_base_tip(pose), from_, 2, search)) {
        if (!collision_.contact(positions, planner_.ignored)) free.push_back(std::move(positions));
      }
    }
    return free;
  }

  /// For rounded corners along what the held object touches in the lift.
  MotionPlanner timing(const MotionLimits& limits) const {
    return {lifting_, space_, limits, planner_.rrt, planner_.ignored};
  }

  /// Greatest acceleration of the held object's middle along a path. [m/s²]
  double greatest_acceleration(const TimedPath& path) const {
    constexpr double period = 0.02;
    const Eigen::Vector3d middle_tip = T_tip_tool_ * middle_of(held_);
    std::vector<Eigen::Vector3d> places;
    for (double time = 0.0; time < path.duration() + period; time += period)
      places.push_back(tip_pose(chain_, path.at(std::min(time, path.duration())).position) *
                       middle_tip);
    double greatest = 0.0;
    for (std::size_t i = 2; i < places.size(); ++i) {
      const Eigen::Vector3d change = places[i] - 2.0 * places[i - 1] + places[i - 2];
      greatest = std::max(greatest, change.norm() / (period * period));
    }
    return greatest;
  }

  /// The motion, slow enough that the fingers can hold the object.
  TimedPath slow(const FreeMotion& motion) const {
    const double factor =
        std::sqrt(greatest_acceleration(*motion.path) / in_.options.execution.carry_acceleration);
    if (factor <= 1.0) return *motion.path;
    const MotionLimits limits = slowed(limits_, factor);
    return timed_motion(timing(limits), motion.waypoints);
  }

  static constexpr double line_step = 0.02;  // between poses of an upright way [m]
  static constexpr double max_jump = 0.3;    // of a joint between two of them [rad]

  const PickScene& in_;
  Eigen::VectorXd from_;
  ArmChain chain_;
  Eigen::Isometry3d T_table_base_, T_tip_tool_;
  std::vector<Eigen::Vector3f> held_;
  JointSpace space_;
  MotionLimits limits_;
  MotionObstacles obstacles_;
  ArmCollision collision_, lifting_;
  MotionPlanner planner_;
};

}  // namespace

PlaceMotion plan_place(const PickScene& in, const Eigen::VectorXd& start, const PickMotion& pick,
                       const Grasp& grasp) {
  return PlacePlanner(in, start, pick, grasp).plan();
}

PlaceMotion plan_home(const PickScene& in, const Eigen::VectorXd& start, int without) {
  const MotionObstacles obstacles(in.scene, {}, seen_obstacles(in));
  const ArmCollision collision(in.robot, in.arm, &in.gripper, in.gripper.max_opening, obstacles,
                               start, in.options.pick.collision);
  const JointSpace space = joint_space(in.robot.model, in.arm.arm);
  const MotionLimits limits = motion_limits(in.robot.model, in.arm.arm, in.options.pick.speed);
  FreeMotion motion = plan_free_motion(
      {collision, space, limits, in.options.pick.rrt, {without, without}},
      arm_positions(in.arm.arm, start), {arm_positions(in.arm.arm, in.robot.home)});
  return {std::move(motion.path), std::move(motion.obstacle)};
}

}  // namespace symscene
