#include "pick_bin.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/joined_meshes.hpp"
#include "core/rigid_motion.hpp"
#include "robots/solid_mesh.hpp"
#include "simulation/shapes.hpp"
#include "symscene/motion/arm_collision.hpp"
#include "symscene/robots/inverse_kinematics.hpp"

namespace symscene {
namespace {

constexpr double gap = 0.02;            // between table and bin [m]
constexpr double least_distance = 0.4;  // of the bin's middle from the shoulder [m]
constexpr int hand_yaws = 8;

/// Middles of bins along the four sides of the table.
std::vector<Eigen::Vector2d> places_beside(const TableOptions& table, double width) {
  constexpr int along = 5;
  const double off = gap + PickBin::wall + 0.5 * width;
  const Eigen::Vector2d half(0.5 * table.length, 0.5 * table.width);
  std::vector<Eigen::Vector2d> places;
  for (int axis = 0; axis < 2; ++axis) {
    for (int k = 0; k < along; ++k) {
      for (const double side : {-1.0, 1.0}) {
        Eigen::Vector2d place;
        place[axis] = side * (half[axis] + off);
        place[1 - axis] = half[1 - axis] * (2.0 * k / (along - 1) - 1.0);
        places.push_back(place);
      }
    }
  }
  return places;
}

/// Asks whether an arm can hold its hand above bins.
class BinReach {
 public:
  BinReach(const Robot& robot, const RobotArm& arm, const Gripper& gripper)
      : robot_(robot),
        arm_(arm),
        gripper_(gripper),
        chain_(arm_chain(robot.model, arm.arm)),
        T_table_base_(robot.T_world_base * link_poses(robot.model, robot.home)[arm.arm.base_link]) {
  }

  Eigen::Vector2d shoulder() const {
    return (T_table_base_ * chain_.joints.front().T_previous_joint).translation().head<2>();
  }

  /// With room for flat and for tall objects below the hand, and for the arm at home.
  bool reaches(const PickBin& bin) const {
    GraspScene scene;
    scene.table = Plane{};
    bin.add_walls_to(scene.obstacles);
    const MotionObstacles obstacles(scene);
    const ArmCollision collision(robot_, arm_, &gripper_, gripper_.max_opening, obstacles,
                                 robot_.home);
    return !collision.contact(arm_positions(arm_.arm, robot_.home)) &&
           reaches_at(bin, bin.height + 0.06, collision) &&
           reaches_at(bin, bin.height + 0.2, collision);
  }

 private:
  bool reaches_at(const PickBin& bin, double tips, const ArmCollision& collision) const {
    const Eigen::Vector3d point(bin.middle.x(), bin.middle.y(), tips + gripper_.finger_depth);
    const Eigen::VectorXd home = arm_positions(arm_.arm, robot_.home);
    for (int k = 0; k < hand_yaws; ++k) {
      const Eigen::Isometry3d T_table_tool =
          tool_pointing_down(point, 2.0 * std::numbers::pi * k / hand_yaws);
      const auto solutions = inverse_kinematics_solutions(
          chain_, T_table_base_.inverse() * T_table_tool * arm_.T_tip_tool(gripper_).inverse(),
          home, 2);
      for (const Eigen::VectorXd& positions : solutions) {
        if (!collision.contact(positions)) return true;
      }
    }
    return false;
  }

  const Robot& robot_;
  const RobotArm& arm_;
  const Gripper& gripper_;
  ArmChain chain_;
  Eigen::Isometry3d T_table_base_;
};

}  // namespace

std::vector<FixedBox> PickBin::boxes() const {
  const double inner = 0.5 * width, outer = inner + wall;
  const auto box = [&](double x0, double x1, double y0, double y1, double top) {
    return FixedBox{{middle.x() + x0, middle.y() + y0, 0.0},
                    {middle.x() + x1, middle.y() + y1, top}};
  };
  return {box(-outer, outer, -outer, outer, wall), box(-outer, -inner, -outer, outer, height),
          box(inner, outer, -outer, outer, height), box(-outer, outer, -outer, -inner, height),
          box(-outer, outer, inner, outer, height)};
}

bool PickBin::is_above(const Eigen::Vector3d& point) const {
  return (point.head<2>() - middle).cwiseAbs().maxCoeff() < 0.5 * width && point.z() > 0.0;
}

void PickBin::add_walls_to(Points& obstacles) const {
  constexpr double spacing = 0.02;
  const double half = 0.5 * (width + wall);
  const int along = static_cast<int>(std::ceil(2.0 * half / spacing));
  const int up = static_cast<int>(std::ceil(height / spacing));
  Eigen::Index row = obstacles.rows();
  obstacles.conservativeResize(row + 4 * along * (up + 1), 3);
  for (int i = 0; i < along; ++i) {
    const double t = -half + 2.0 * half * i / along;
    for (int k = 0; k <= up; ++k) {
      const double z = height * k / up;
      for (const auto& [x, y] : {std::pair(t, -half), {half, t}, {-t, half}, {-half, -t}})
        obstacles.row(row++) = Eigen::RowVector3d(middle.x() + x, middle.y() + y, z).cast<float>();
    }
  }
}

TriangleMesh PickBin::mesh() const {
  std::vector<TriangleMesh> parts;
  for (const FixedBox& box : boxes()) parts.push_back(box_mesh({box.min, box.max}));
  return joined(parts);
}

Eigen::Isometry3d tool_pointing_down(const Eigen::Vector3d& point, double angle) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = tool_axes({std::cos(angle), std::sin(angle), 0.0}, -Eigen::Vector3d::UnitZ());
  pose.translation() = point;
  return pose;
}

std::optional<PickBin> reachable_bin(const Robot& robot, const RobotArm& arm,
                                     const Gripper& gripper, const TableOptions& table,
                                     const PickExecutionOptions& options) {
  const BinReach reach(robot, arm, gripper);
  const Eigen::Vector2d shoulder = reach.shoulder();
  std::vector<Eigen::Vector2d> places = places_beside(table, options.bin_width);
  const auto distance = [&](const Eigen::Vector2d& place) { return (place - shoulder).norm(); };
  std::erase_if(places, [&](const auto& place) { return distance(place) < least_distance; });
  std::stable_sort(places.begin(), places.end(),
                   [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  for (const Eigen::Vector2d& place : places) {
    const PickBin bin{place, options.bin_width, options.bin_height};
    if (reach.reaches(bin)) return bin;
  }
  return std::nullopt;
}

}  // namespace symscene
