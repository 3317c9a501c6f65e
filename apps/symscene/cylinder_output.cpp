#include "cylinder_output.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "symscene/io/grasps.hpp"

namespace symscene::app {
namespace {

using Json = nlohmann::ordered_json;

/// What the bound of an axis compares.
const char* meaning(AxisOutcome outcome) {
  switch (outcome) {
    case AxisOutcome::no_fit:
      return "no axis could be fitted";
    case AxisOutcome::symmetry:
      return "the normals do not lie in planes through the axis";
    case AxisOutcome::perpendicularity:
      return "the normals are parallel to the axis";
    case AxisOutcome::coverage:
      return "too small an angle about the axis was seen";
    case AxisOutcome::occlusion:
      return "turned about the axis it enters space that was seen empty";
    case AxisOutcome::accepted:
      return "";
  }
  return "";
}

std::string format_failure(const AxisJudgement& judgement) {
  const std::string reason = fmt::format("  no axis: {}", meaning(judgement.outcome));
  if (judgement.outcome == AxisOutcome::no_fit) return reason;
  return fmt::format("{} ({:.3f}, bound {:.3f})", reason, judgement.value, judgement.bound);
}

std::string format_grasps_of(const GraspPlan& plan, std::size_t id) {
  const ObjectGraspSummary& summary = plan.objects.at(id);
  if (!summary.reason) return fmt::format("  {:>6}", summary.grasps);
  return fmt::format("  {:>6}  none: {}", 0, description(*summary.reason));
}

Json to_json(const Eigen::Vector3d& vector) { return {vector.x(), vector.y(), vector.z()}; }

Json to_json(const AxisQuality& quality) {
  return {{"symmetry_residual", quality.symmetry_residual},
          {"perpendicularity", quality.perpendicularity},
          {"coverage", quality.coverage},
          {"occlusion_residual", quality.occlusion_residual}};
}

Json to_json(const ClusterCylinder& cluster, std::size_t id) {
  Json json = {{"id", id}, {"points", cluster.points.size()}};
  if (cluster.cylinder) {
    json["cylinder"] = {{"center", to_json(cluster.cylinder->center)},
                        {"direction", to_json(cluster.cylinder->direction)},
                        {"radius", cluster.cylinder->radius},
                        {"height", cluster.cylinder->height}};
  } else {
    json["reason"] = to_string(cluster.judgement.outcome);
    json["value"] = cluster.judgement.value;
    json["bound"] = cluster.judgement.bound;
  }
  if (cluster.judgement.outcome != AxisOutcome::no_fit) json["axis"] = to_json(cluster.quality);
  return json;
}

ObjectClass as_class(const BoundingCylinder& cylinder) {
  ObjectClass result;
  result.kind = SymmetryClass::cylinder;
  result.center = cylinder.center;
  result.axes.leftCols<2>() = orthonormal_complement(cylinder.direction);
  result.axes.col(2) = cylinder.direction;
  const std::string reason = "around the points that were seen";
  result.dimensions = {{"radius", cylinder.radius, std::nullopt, reason},
                       {"height", cylinder.height, std::nullopt, reason}};
  return result;
}

}  // namespace

std::size_t cylinder_count(const CylinderScene& scene) {
  return static_cast<std::size_t>(
      std::count_if(scene.clusters.begin(), scene.clusters.end(),
                    [](const ClusterCylinder& cluster) { return cluster.cylinder.has_value(); }));
}

std::string format_cylinders(const CylinderScene& scene, const GraspPlan& plan) {
  std::string table =
      " id  points   radius   height  grasps\n"
      "                [cm]     [cm]";
  for (std::size_t id = 0; id < scene.clusters.size(); ++id) {
    const ClusterCylinder& cluster = scene.clusters[id];
    table += fmt::format("\n{:>3}  {:>6}", id, cluster.points.size());
    if (cluster.cylinder) {
      table += fmt::format("  {:>7.2f}  {:>7.2f}", 100.0 * cluster.cylinder->radius,
                           100.0 * cluster.cylinder->height);
      table += format_grasps_of(plan, id);
    } else {
      table += format_failure(cluster.judgement);
    }
  }
  return table + fmt::format("\n{} of {} clusters have an axis", cylinder_count(scene),
                             scene.clusters.size());
}

std::string format_cylinders_json(const CylinderScene& scene, const GraspPlan& plan,
                                  const Gripper& gripper) {
  Json document = Json::parse(format_grasps_json(plan, gripper, false));
  document["clusters"] = Json::array();
  for (std::size_t id = 0; id < scene.clusters.size(); ++id)
    document["clusters"].push_back(to_json(scene.clusters[id], id));
  return document.dump() + "\n";
}

SegmentationResult cylinders_as_objects(const CylinderScene& scene) {
  SegmentationResult result;
  result.cloud = scene.cloud;
  result.table = scene.table;
  result.timings = scene.timings;
  result.warnings = scene.warnings;
  for (const ClusterCylinder& cluster : scene.clusters) {
    SceneObject object;
    object.points = cluster.points;
    if (cluster.cylinder) {
      object.confidence = 1.0 - cluster.quality.symmetry_residual;
      object.rotational.push_back({{cluster.cylinder->center, cluster.cylinder->direction},
                                   cluster.quality.symmetry_residual});
      object.symmetry_class = as_class(*cluster.cylinder);
    }
    result.objects.push_back(std::move(object));
  }
  return result;
}

}  // namespace symscene::app
