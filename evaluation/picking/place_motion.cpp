#include "place_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/voxel_sampling.hpp"
#include "free_motion.hpp"
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

/// Greatest acceleration of a point of the tool frame along a path. [m/s²]
double greatest_acceleration(const PickScene& in, const TimedPath& path,
                             const Eigen::Vector3d& point_tool) {
  constexpr double period = 0.02;
  const ArmChain chain = arm_chain(in.robot.model, in.arm.arm);
  const Eigen::Vector3d point_tip = in.arm.T_tip_tool(in.gripper) * point_tool;
  std::vector<Eigen::Vector3d> places;
  for (double time = 0.0; time < path.duration() + period; time += period)
    places.push_back(tip_pose(chain, path.at(std::min(time, path.duration())).position) *
                     point_tip);
  double greatest = 0.0;
  for (std::size_t i = 2; i < places.size(); ++i) {
    const Eigen::Vector3d change = places[i] - 2.0 * places[i - 1] + places[i - 2];
    greatest = std::max(greatest, change.norm() / (period * period));
  }
  return greatest;
}

/// The motion slowed down so that the held object does not slip out of the fingers.
TimedPath carried(const PickScene& in, const MotionPlanner& planner, const FreeMotion& motion,
                  const Eigen::Vector3d& middle) {
  const double factor = std::sqrt(greatest_acceleration(in, *motion.path, middle) /
                                  in.options.execution.carry_acceleration);
  if (factor <= 1.0) return *motion.path;
  const MotionLimits limits = slowed(planner.limits, factor);
  return timed_motion({planner.collision, planner.space, limits, planner.rrt, planner.ignored},
                      motion.waypoints);
}

/// Free joint positions at tool poses.
std::vector<Eigen::VectorXd> free_positions(const PickScene& in, const Eigen::VectorXd& start,
                                            const std::vector<Eigen::Isometry3d>& poses,
                                            const ArmCollision& collision,
                                            const IgnoredObstacles& ignored) {
  const ArmChain chain = arm_chain(in.robot.model, in.arm.arm);
  const Eigen::Isometry3d T_table_base =
      in.robot.T_world_base * link_poses(in.robot.model, start)[in.arm.arm.base_link];
  InverseKinematicsOptions search;
  search.max_starts = 8;
  std::vector<Eigen::VectorXd> free;
  for (const Eigen::Isometry3d& pose : poses) {
    const Eigen::Isometry3d T_base_tip =
        T_table_base.inverse() * pose * in.arm.T_tip_tool(in.gripper).inverse();
    for (auto& positions : inverse_kinematics_solutions(
             chain, T_base_tip, arm_positions(in.arm.arm, start), 2, search)) {
      if (!collision.contact(positions, ignored)) free.push_back(std::move(positions));
    }
  }
  return free;
}

/// Obstacles of the scene but never-seen space: the arm and the object came out of it.
MotionObstacleOptions seen_obstacles(const PickScene& in) {
  MotionObstacleOptions options = in.options.pick.obstacles;
  options.never_seen = false;
  return options;
}

}  // namespace

PlaceMotion plan_place(const PickScene& in, const Eigen::VectorXd& start, const PickMotion& pick,
                       const Grasp& grasp) {
  const Eigen::VectorXd from = pick.retreat.at(pick.retreat.duration()).position;
  const Eigen::VectorXd at_grasp = pick.retreat.at(0.0).position;
  const Eigen::VectorXd all = with_arm_positions(in.arm.arm, at_grasp, start);
  const Eigen::Isometry3d T_table_tool = in.robot.T_world_base *
                                         link_poses(in.robot.model, all)[in.arm.arm.tip_link] *
                                         in.arm.T_tip_tool(in.gripper);
  const auto held =
      held_points(in.scene.objects[static_cast<std::size_t>(grasp.object)], T_table_tool);
  const MotionObstacles obstacles(in.scene, {}, seen_obstacles(in));
  ArmCollision collision(in.robot, in.arm, &in.gripper, grasp.opening, obstacles, start,
                         in.options.pick.collision);
  collision.hold(held);
  const IgnoredObstacles ignored{grasp.object, grasp.object};
  std::vector<Eigen::Isometry3d> poses = poses_above(in.bin, T_table_tool.linear(), held, in);
  const Eigen::Matrix3d down = tool_pointing_down(Eigen::Vector3d::Zero(), 0.0).linear();
  for (const Eigen::Isometry3d& pose : poses_above(in.bin, down, held, in)) poses.push_back(pose);
  const auto goals =
      free_positions(in, with_arm_positions(in.arm.arm, from, start), poses, collision, ignored);
  const JointSpace space = joint_space(in.robot.model, in.arm.arm);
  const MotionLimits limits = motion_limits(in.robot.model, in.arm.arm, in.options.pick.speed);
  const MotionPlanner planner{collision, space, limits, in.options.pick.rrt, ignored};
  FreeMotion motion = plan_free_motion(planner, from, goals);
  if (motion.path) motion.path = carried(in, planner, motion, middle_of(held));
  return {std::move(motion.path), std::move(motion.obstacle)};
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
