#pragma once

#include <array>
#include <vector>

#include "core/rigid_motion.hpp"
#include "grasping/hand_shape.hpp"
#include "simulation/shapes.hpp"
#include "symscene/grasping/gripper.hpp"
#include "symscene/grasping/planner.hpp"

/// Objects with known surfaces on the table z = 0.
namespace symscene::testing {

inline GraspObject seen_all_over(const TriangleMesh& mesh) {
  GraspObject object;
  object.surface = {mesh,
                    std::vector<std::uint8_t>(static_cast<std::size_t>(mesh.triangles.rows()), 1)};
  return object;
}

inline GraspScene on_table(const std::vector<GraspObject>& objects) {
  GraspScene scene;
  scene.table = Plane{};
  scene.objects = objects;
  return scene;
}

inline TriangleMesh shifted(const TriangleMesh& mesh, const Eigen::Vector3d& by) {
  return transformed(mesh, Eigen::Isometry3d(Eigen::Translation3d(by)));
}

/// A box that stands on the table at (x, y).
inline GraspObject box_at(const Eigen::Vector3d& size, double x, double y) {
  return seen_all_over(shifted(make_box(size, 0.01), {x, y, 0.0}));
}

inline GraspObject cylinder_at(double radius, double height, double x, double y) {
  const std::array<ProfilePoint, 4> profile{
      ProfilePoint{0.0, 0.0}, {radius, 0.0}, {radius, height}, {0.0, height}};
  GraspObject object = seen_all_over(shifted(make_revolution(profile, 64, 0.005), {x, y, 0.0}));
  object.axes.push_back({{{x, y, 0.0}, Eigen::Vector3d::UnitZ()}, 0.01});
  return object;
}

/// A bowl about the z axis, 7 cm high, with a wall of 4 mm.
inline GraspObject bowl(double radius) {
  const double wall = 0.004;
  const std::array<ProfilePoint, 6> profile{
      ProfilePoint{0.0, 0.0}, {0.6 * radius, 0.0},         {radius, 0.07},
      {radius - wall, 0.07},  {0.6 * radius - wall, wall}, {0.0, wall}};
  GraspObject object = seen_all_over(make_revolution(profile, 96, 0.005));
  object.axes.push_back({{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()}, 0.01});
  return object;
}

/// Five objects, some of them close to each other.
inline GraspScene clutter() {
  return on_table({box_at({0.05, 0.1, 0.12}, 0.0, 0.0), cylinder_at(0.03, 0.1, 0.12, 0.02),
                   box_at({0.06, 0.06, 0.05}, -0.11, 0.0), cylinder_at(0.02, 0.15, 0.02, 0.13),
                   box_at({0.03, 0.15, 0.04}, 0.1, -0.15)});
}

inline std::vector<Grasp> grasps_of(const GraspPlan& plan, int object) {
  std::vector<Grasp> grasps;
  for (const Grasp& grasp : plan.grasps) {
    if (grasp.object == object) grasps.push_back(grasp);
  }
  return grasps;
}

/// The boxes that the open gripper sweeps on its way to a grasp.
inline std::vector<HandBox> swept_boxes(const Gripper& gripper) {
  return hand_shape(gripper, gripper.max_opening, gripper.approach_distance).boxes;
}

}  // namespace symscene::testing
