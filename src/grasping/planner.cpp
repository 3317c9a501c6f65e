#include "symscene/grasping/planner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "closing_lines.hpp"
#include "contacts.hpp"
#include "core/parallel.hpp"

namespace symscene {
namespace {

struct ObjectPlan {
  std::vector<Grasp> grasps;
  std::vector<RejectedGrasp> rejected;
  ObjectGraspSummary summary;
};

std::vector<Eigen::Isometry3d> approaches(const GraspTarget& target, const ClosingLine& line,
                                          const Gripper& gripper, const GraspOptions& options) {
  std::vector<Eigen::Isometry3d> poses;
  const Eigen::Vector3d y = line.direction;
  const Eigen::Vector3d down = -(target.up - target.up.dot(y) * y);
  if (down.norm() < 0.2) return poses;
  for (int k = 0; k < options.approaches; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / options.approaches;
    const Eigen::Vector3d z = Eigen::AngleAxisd(angle, y) * down.normalized();
    if (z.dot(target.up) > 0.1) continue;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() << y.cross(z), y, z;
    pose.translation() = line.centre - (gripper.finger_depth - 0.015) * z;
    poses.push_back(pose);
  }
  return poses;
}

double table_clearance(const Eigen::Isometry3d& pose, const Gripper& gripper, const Plane& table) {
  double least = 1.0;
  const double y = gripper.max_opening / 2.0 + gripper.finger_thickness;
  const double x = (gripper.finger_width + gripper.finger_spacing) / 2.0;
  for (const double sx : {-x, x}) {
    for (const double sy : {-y, y}) {
      least = std::min(least, table.signed_distance(pose * Eigen::Vector3d(sx, sy, 0.0)));
      least = std::min(least,
                       table.signed_distance(pose * Eigen::Vector3d(sx, sy, gripper.finger_depth)));
    }
  }
  return least;
}

void judge(const GraspTarget& target, Grasp grasp, const GraspScene& scene, const Gripper& gripper,
           const GraspOptions& options, ObjectPlan& plan) {
  ++plan.summary.candidates;
  const auto reject = [&](GraspRejection reason, double value, double bound) {
    ++plan.summary.rejected.at(static_cast<std::size_t>(reason));
    plan.rejected.push_back({grasp, reason, value, bound});
  };
  const auto contacts = find_contacts(target.samples, grasp.T_world_tool, gripper);
  if (!contacts) return reject(GraspRejection::no_contact, 0.0, 0.0);
  grasp.opening = contacts->opening();
  const double angle =
      std::max(angle_between(contacts->positive.normal, Eigen::Vector3d::UnitY()),
               angle_between(contacts->negative.normal, -Eigen::Vector3d::UnitY()));
  grasp.features.cone_margin = std::atan(gripper.friction) - angle;
  if (grasp.features.cone_margin < 0.0)
    return reject(GraspRejection::friction, angle, std::atan(gripper.friction));
  if (scene.table) {
    const double clearance = table_clearance(grasp.T_world_tool, gripper, *scene.table);
    if (clearance < options.table_clearance)
      return reject(GraspRejection::table, clearance, options.table_clearance);
  }
  grasp.quality = 0.5 + 0.5 * grasp.features.cone_margin / std::atan(gripper.friction);
  plan.grasps.push_back(grasp);
}

ObjectPlan plan_object(const GraspScene& scene, std::size_t id, const Gripper& gripper,
                       const GraspOptions& options) {
  ObjectPlan plan;
  const GraspObject& object = scene.objects[id];
  if (object.surface.mesh.triangles.rows() == 0) {
    plan.summary.reason = GraspRejection::no_surface;
    return plan;
  }
  const Eigen::Vector3d up = scene.table ? scene.table->normal : Eigen::Vector3d::UnitZ();
  const GraspTarget target{static_cast<int>(id), object, surface_samples(object.surface),
                           object.solid ? *object.solid : solid_properties(object.surface.mesh),
                           up};
  for (const ClosingLine& line : antipodal_lines(target, options)) {
    if (line.width > gripper.max_opening) {
      ++plan.summary.rejected.at(static_cast<std::size_t>(GraspRejection::too_wide));
      continue;
    }
    for (const Eigen::Isometry3d& pose : approaches(target, line, gripper, options))
      judge(target, {target.object, pose, 0.0, 0.0, line.source}, scene, gripper, options, plan);
  }
  const auto better = [](const Grasp& a, const Grasp& b) { return a.quality > b.quality; };
  std::stable_sort(plan.grasps.begin(), plan.grasps.end(), better);
  if (plan.grasps.size() > static_cast<std::size_t>(options.max_grasps))
    plan.grasps.resize(static_cast<std::size_t>(options.max_grasps));
  plan.summary.grasps = plan.grasps.size();
  return plan;
}

}  // namespace

GraspPlan plan_grasps(const GraspScene& scene, const Gripper& gripper,
                      const GraspOptions& options) {
  gripper.validate();
  options.validate();
  std::vector<ObjectPlan> plans(scene.objects.size());
  StageTimer timer;
  timer.time("grasps", [&] {
    parallel_for_each(plans.size(),
                      [&](std::size_t i) { plans[i] = plan_object(scene, i, gripper, options); });
  });
  GraspPlan plan;
  for (const ObjectPlan& object : plans) {
    plan.grasps.insert(plan.grasps.end(), object.grasps.begin(), object.grasps.end());
    plan.rejected.insert(plan.rejected.end(), object.rejected.begin(), object.rejected.end());
    plan.objects.push_back(object.summary);
  }
  std::stable_sort(plan.grasps.begin(), plan.grasps.end(),
                   [](const Grasp& a, const Grasp& b) { return a.quality > b.quality; });
  plan.timings = timer.stages();
  return plan;
}

}  // namespace symscene
