#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/joined_meshes.hpp"
#include "core/random.hpp"
#include "core/surface_sampling.hpp"
#include "method_parts.hpp"

namespace symscene {
namespace {

constexpr std::size_t samples = 2000;         // of a surface
constexpr std::size_t samples_of_all = 6000;  // of all surfaces together
constexpr int proposals = 20;                 // of the random methods
constexpr double tip_overlap = 0.02;          // distance of a grasped point from the fingertips [m]
constexpr double cone_angle = radians(20.0);  // of antipodal normals with the closing direction

Eigen::Vector3d random_direction(Random& random) {
  return Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
}

/// The tool frame that holds a point between its fingers.
Eigen::Isometry3d tool_at(const Eigen::Vector3d& point, const Eigen::Vector3d& approach,
                          const Eigen::Vector3d& closing, const Gripper& gripper) {
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
  T_world_tool.linear() << closing.cross(approach), closing, approach;
  T_world_tool.translation() = point - (gripper.finger_depth - tip_overlap) * approach;
  return T_world_tool;
}

/// A direction of approach that does not point upwards.
Eigen::Vector3d random_approach(const Eigen::Vector3d& closing, Random& random) {
  Eigen::Vector3d approach;
  do approach = closing.cross(random_direction(random)).normalized();
  while (approach.z() > 0.0);
  return approach;
}

PointCloud sampled_surfaces(const ClutterWorld& world) {
  return sample_surface(joined(world.surfaces()), samples_of_all);
}

/// The point of the surface that a line from point `i` along `inward` leaves it at.
std::optional<Index> opposite_point(const PointCloud& surface, Index i,
                                    const Eigen::Vector3d& inward, double max_width) {
  constexpr double max_offset = 0.003;  // of a sample from the line [m]
  const Eigen::Vector3d start = surface.position(i).cast<double>();
  std::optional<Index> nearest;
  double nearest_width = max_width;
  for (Index k = 0; k < surface.size(); ++k) {
    const Eigen::Vector3d way = surface.position(k).cast<double>() - start;
    const double width = inward.dot(way);
    if (width < 0.005 || width > nearest_width) continue;
    if ((way - width * inward).norm() > max_offset) continue;
    if (surface.normal(k).cast<double>().dot(inward) < std::cos(cone_angle)) continue;
    nearest = k;
    nearest_width = width;
  }
  return nearest;
}

Grasp grasp_of(const Eigen::Isometry3d& T_world_tool, double opening) {
  Grasp grasp;
  grasp.T_world_tool = T_world_tool;
  grasp.opening = opening;
  return grasp;
}

}  // namespace

std::vector<Grasp> random_grasps(const ClutterWorld& world, const Gripper& gripper, Random random) {
  const PointCloud surface = sampled_surfaces(world);
  std::vector<Grasp> grasps;
  for (int k = 0; k < proposals; ++k) {
    const Index i = random.below(static_cast<std::uint32_t>(surface.size()));
    const Eigen::Vector3d closing = random_direction(random);
    grasps.push_back(grasp_of(tool_at(surface.position(i).cast<double>(),
                                      random_approach(closing, random), closing, gripper),
                              gripper.max_opening));
  }
  return grasps;
}

std::vector<Grasp> random_antipodal_grasps(const ClutterWorld& world, const Gripper& gripper,
                                           Random random) {
  const PointCloud surface = sampled_surfaces(world);
  std::vector<Grasp> grasps;
  constexpr int attempts = 2000;
  for (int k = 0; k < attempts && grasps.size() < proposals; ++k) {
    const Index i = random.below(static_cast<std::uint32_t>(surface.size()));
    const Eigen::Vector3d closing = -surface.normal(i).cast<double>().normalized();
    const std::optional<Index> other = opposite_point(surface, i, closing, gripper.max_opening);
    if (!other) continue;
    const Eigen::Vector3d a = surface.position(i).cast<double>();
    const Eigen::Vector3d b = surface.position(*other).cast<double>();
    grasps.push_back(
        grasp_of(tool_at(0.5 * (a + b), random_approach(closing, random), closing, gripper),
                 (b - a).norm()));
  }
  return grasps;
}

GraspScene true_grasp_scene(const ClutterWorld& world) {
  GraspScene scene;
  for (const TriangleMesh& mesh : world.surfaces()) {
    GraspObject object;
    object.observed = sample_surface(mesh, samples);
    object.surface.mesh = mesh;
    object.surface.observed.assign(static_cast<std::size_t>(mesh.triangles.rows()), 1);
    scene.objects.push_back(std::move(object));
  }
  scene.table = Plane{Eigen::Vector3d::UnitZ(), -clutter::table_height};
  return scene;
}

}  // namespace symscene
