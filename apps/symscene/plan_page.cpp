#include "plan_page.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/median.hpp"
#include "core/rigid_motion.hpp"
#include "robots/robot_solids.hpp"
#include "robots/solid_mesh.hpp"
#include "symscene/core/geometry.hpp"
#include "symscene/robots/reachability.hpp"

namespace symscene::app {
namespace {

constexpr double frame_rate = 20.0;       // recorded moments per second
constexpr double margin = 0.25;           // of the map around the objects [m]
constexpr double least_spacing = 0.04;    // of its cells [m]
constexpr double most_cells = 600.0;      // about
constexpr double usual_height = 0.1;      // of the finger tips if there are no grasps [m]
constexpr double table_thickness = 0.03;  // [m]

/// z along the table's normal, origin on it. Without a table z is up, and objects stand on it.
Eigen::Isometry3d T_table_world(const GraspScene& scene) {
  Eigen::Isometry3d T_world_table = Eigen::Isometry3d::Identity();
  if (scene.table) {
    const Plane& table = *scene.table;
    T_world_table.translation() = -table.offset * table.normal;
    T_world_table.linear() = shortest_rotation(Eigen::Vector3d::UnitZ(), table.normal);
    return T_world_table.inverse();
  }
  Eigen::AlignedBox3f box;
  for (const GraspObject& object : scene.objects)
    for (Eigen::Index i = 0; i < object.surface.mesh.vertices.rows(); ++i)
      box.extend(object.surface.mesh.vertices.row(i).transpose());
  if (!box.isEmpty()) T_world_table.translation().z() = box.min().z();
  return T_world_table.inverse();
}

class PlanRecorder {
 public:
  explicit PlanRecorder(const PlanToShow& plan)
      : plan_(plan),
        T_table_world_(T_table_world(plan.scene)),
        robot_(plan.robot),
        solids_(on_table(), plan.arm, plan.gripper) {
    for (const GraspObject& object : plan.scene.objects)
      surfaces_.push_back(transformed(object.surface.mesh, T_table_world_));
  }

  PlanRecording record() {
    PlanRecording recording;
    recording.motion = motion();
    recording.grasps = grasps();
    recording.finger_depth = plan_.gripper.finger_depth;
    recording.reach = reach();
    return recording;
  }

 private:
  const Robot& on_table() {
    robot_.T_world_base = T_table_world_ * plan_.robot.T_world_base;
    return robot_;
  }

  /// Of all objects; empty without any.
  Eigen::AlignedBox3d bounds() const {
    Eigen::AlignedBox3d box;
    for (const TriangleMesh& surface : surfaces_)
      for (Eigen::Index i = 0; i < surface.vertices.rows(); ++i)
        box.extend(surface.vertices.row(i).transpose().cast<double>());
    return box;
  }

  Eigen::AlignedBox3d area() const {
    const Eigen::AlignedBox3d box = bounds();
    const Eigen::Vector3d beside(margin, margin, 0.0);
    return {box.min() - beside, box.max() + beside};
  }

  RunRecording motion() const {
    RunRecording run;
    for (const RobotSolid& solid : solids_.solids())
      run.solids.push_back(
          {solid.name, solid.mesh, solid.is_hand ? RecordedKind::hand : RecordedKind::robot});
    for (std::size_t k = 0; k < surfaces_.size(); ++k)
      run.solids.push_back({"object " + std::to_string(k), surfaces_[k], RecordedKind::object});
    if (!bounds().isEmpty()) run.solids.push_back({"table", table(), RecordedKind::table});
    if (plan_.trajectory)
      add_moments(run);
    else
      add_moment(0.0, {plan_.start, plan_.gripper.max_opening}, std::nullopt, run);
    run.events = events();
    return run;
  }

  TriangleMesh table() const {
    Eigen::AlignedBox3d box = area();
    box.max().z() = 0.0;
    box.min().z() = -table_thickness;
    return box_mesh(box);
  }

  void add_moments(RunRecording& run) const {
    const JointTrajectory& trajectory = *plan_.trajectory;
    double next = 0.0;
    std::optional<Eigen::Isometry3d> T_grasp_table;  // since the object is held
    for (const JointTrajectoryPoint& point : trajectory.points) {
      const RobotState state = state_at(point);
      if (!T_grasp_table && point.time >= closed()) T_grasp_table = solids_.tool(state).inverse();
      const bool is_last = &point == &trajectory.points.back();
      if (point.time < next && !is_last && point.time != closed()) continue;
      next += 1.0 / frame_rate;
      add_moment(point.time, state, T_grasp_table, run);
    }
  }

  /// Solids of the robot, then objects, of which the held one follows the tool, then the table.
  void add_moment(double time, const RobotState& state,
                  const std::optional<Eigen::Isometry3d>& T_grasp_table, RunRecording& run) const {
    std::vector<Eigen::Isometry3d> poses = solids_.poses(state);
    const std::size_t first_object = poses.size();
    poses.resize(run.solids.size(), Eigen::Isometry3d::Identity());
    if (T_grasp_table) poses[first_object + held_object()] = solids_.tool(state) * *T_grasp_table;
    run.times.push_back(time);
    run.poses.push_back(std::move(poses));
  }

  std::size_t held_object() const {
    return static_cast<std::size_t>(plan_.grasps[plan_.pick.motion->grasp].object);
  }

  const JointTrajectoryPart& part(const char* name) const {
    const auto& parts = plan_.trajectory->parts;
    return *std::find_if(parts.begin(), parts.end(),
                         [&](const JointTrajectoryPart& each) { return each.name == name; });
  }
  double time_of(std::size_t point) const { return plan_.trajectory->points[point].time; }
  double closed() const { return time_of(part("grasp").end); }

  /// The fingers close evenly during the pause at the grasp.
  RobotState state_at(const JointTrajectoryPoint& point) const {
    RobotState state{plan_.start, plan_.gripper.max_opening};
    for (std::size_t k = 0; k < plan_.arm.arm.positions.size(); ++k)
      state.positions[static_cast<Eigen::Index>(plan_.arm.arm.positions[k])] =
          point.positions[static_cast<Eigen::Index>(k)];
    const double begin = time_of(part("grasp").begin);
    const double share = std::clamp((point.time - begin) / (closed() - begin), 0.0, 1.0);
    state.opening = std::lerp(state.opening, plan_.grasps[plan_.pick.motion->grasp].opening, share);
    return state;
  }

  std::vector<RecordedEvent> events() const {
    if (!plan_.pick.start_contact.empty())
      return {{0.0, "The arm cannot move: " + plan_.pick.start_contact, RecordedOutcome::failure}};
    if (!plan_.trajectory) return {{0.0, "No grasp is reached", RecordedOutcome::failure}};
    return {{time_of(part("to_pre_grasp").begin), "To the start of the straight way"},
            {time_of(part("approach").begin), "Straight to the grasp"},
            {time_of(part("grasp").begin), "The gripper closes"},
            {time_of(part("retreat").begin), "Straight away with the object"}};
  }

  std::vector<ShownGrasp> grasps() const {
    std::vector<ShownGrasp> list;
    for (std::size_t i = 0; i < plan_.grasps.size(); ++i) {
      list.push_back({plan_.numbers[i], plan_.grasps[i], ShownGraspState::not_tried, ""});
      Eigen::Isometry3d& tool = list.back().grasp.T_world_tool;
      tool = T_table_world_ * tool;
    }
    for (const std::size_t i : plan_.pick.reached) list[i].state = ShownGraspState::reached;
    if (plan_.pick.motion) list[plan_.pick.motion->grasp].state = ShownGraspState::chosen;
    for (const RejectedPick& why : plan_.pick.rejected) {
      list[why.grasp].state = ShownGraspState::not_reached;
      list[why.grasp].reason = description(why.reason);
      if (!why.detail.empty()) list[why.grasp].reason += ": " + why.detail;
    }
    return list;
  }

  /// The median height of the finger tips in the grasps.
  double tip_height() const {
    std::vector<double> heights;
    for (const Grasp& grasp : plan_.grasps) {
      const Eigen::Vector3d tips = plan_.gripper.finger_depth * Eigen::Vector3d::UnitZ();
      heights.push_back((T_table_world_ * grasp.T_world_tool * tips).z());
    }
    return std::max(0.0, median(heights).value_or(usual_height));
  }

  std::optional<ShownReach> reach() const {
    if (bounds().isEmpty()) return std::nullopt;
    Eigen::AlignedBox3d box = area();
    box.min().z() = box.max().z() = tip_height();
    ReachabilityOptions options;
    options.spacing =
        std::max(least_spacing, std::sqrt(box.sizes().x() * box.sizes().y() / most_cells));
    const ReachabilityMap map = reachability_map(robot_, plan_.arm, plan_.gripper, box, options);
    ShownReach shown{map.spacing, tip_height(), {}, map.from_above, map.from_side};
    shown.centers.resize(static_cast<Eigen::Index>(map.from_above.size()), 3);
    for (int y = 0; y < map.size[1]; ++y)
      for (int x = 0; x < map.size[0]; ++x)
        shown.centers.row(static_cast<Eigen::Index>(map.index(x, y, 0))) =
            map.point_world(x, y, 0).cast<float>().transpose();
    return shown;
  }

  const PlanToShow& plan_;
  Eigen::Isometry3d T_table_world_;
  Robot robot_;  ///< in the frame of the table
  RobotSolids solids_;
  std::vector<TriangleMesh> surfaces_;  ///< of the objects, in the frame of the table
};

}  // namespace

PlanRecording plan_recording(const PlanToShow& plan) { return PlanRecorder(plan).record(); }

}  // namespace symscene::app
