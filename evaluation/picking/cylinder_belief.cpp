#include "cylinder_belief.hpp"

#include "core/rigid_motion.hpp"
#include "simulation/shapes.hpp"
#include "symscene/core/geometry.hpp"
#include "symscene/grasping/bounding_cylinders.hpp"

namespace symscene {
namespace {

TriangleMesh surface_of(const BoundingCylinder& cylinder) {
  constexpr int segments = 24;
  const double low = -0.5 * cylinder.height, high = 0.5 * cylinder.height;
  const std::vector<ProfilePoint> profile{
      {0.0, low}, {cylinder.radius, low}, {cylinder.radius, high}, {0.0, high}};
  Eigen::Isometry3d pose(Eigen::Translation3d(cylinder.center));
  pose.linear() = shortest_rotation(Eigen::Vector3d::UnitZ(), cylinder.direction);
  return transformed(make_revolution(profile, segments, cylinder.height + cylinder.radius), pose);
}

}  // namespace

TableBelief cylinder_belief(const Scene& scene, const Gripper& gripper, StageTimer& timer) {
  TableBelief belief;
  const CylinderScene found = timer.time("objects", [&] { return fit_cylinders(scene); });
  GraspPlan plan = timer.time("grasps", [&] { return cylinder_grasps(found, gripper); });
  belief.scene.table = found.table;
  for (const ClusterCylinder& cluster : found.clusters) {
    GraspObject object;
    object.observed = select(found.cloud, cluster.points);
    if (cluster.cylinder) object.surface.mesh = surface_of(*cluster.cylinder);
    belief.scene.objects.push_back(std::move(object));
    belief.labels.emplace_back(cluster.cylinder ? "cylinder" : "cluster");
  }
  belief.grasps = std::move(plan.grasps);
  belief.objects = std::move(plan.objects);
  return belief;
}

}  // namespace symscene
