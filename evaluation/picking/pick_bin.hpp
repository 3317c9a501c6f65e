#pragma once

#include <optional>
#include <vector>

#include "symscene/core/gripper.hpp"
#include "symscene/core/triangle_mesh.hpp"
#include "symscene/physics/grasp_world.hpp"
#include "symscene/picking/simulated_pick_options.hpp"
#include "symscene/robots/robot.hpp"
#include "symscene/simulation/tabletop.hpp"

namespace symscene {

/// An open square bin whose floor is level with the table. Frame of the table. [m]
struct PickBin {
  static constexpr double wall = 0.008;  ///< thickness of walls and floor

  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double width = 0.26;   ///< inner
  double height = 0.12;  ///< of the walls

  /// Its floor and its walls.
  std::vector<FixedBox> boxes() const;
  /// Whether a point is above its floor and between its walls, at any height.
  bool is_above(const Eigen::Vector3d& point) const;
  /// Adds points on its walls at most 2 cm apart.
  void add_walls_to(Points& obstacles) const;
  TriangleMesh mesh() const;
};

/// The pose of a tool that points down at a point and closes along the direction with that angle
/// about z.
Eigen::Isometry3d tool_pointing_down(const Eigen::Vector3d& point, double angle);

/// The place beside the table nearest to the arm's shoulder at which the arm can hold its hand
/// above a bin without collision; none if there is no such place.
std::optional<PickBin> reachable_bin(const Robot& robot, const RobotArm& arm,
                                     const Gripper& gripper, const TableOptions& table,
                                     const PickExecutionOptions& options);

}  // namespace symscene
