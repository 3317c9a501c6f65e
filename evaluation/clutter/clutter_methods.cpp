#include "symscene/clutter/clutter_methods.hpp"

#include <array>

#include <fmt/format.h>

#include "clutter/sensed_scene.hpp"
#include "core/random.hpp"
#include "method_parts.hpp"
#include "stopwatch.hpp"
#include "symscene/core/error.hpp"
#include "symscene/grasping/bounding_cylinders.hpp"
#include "symscene/grasping/gripper.hpp"
#include "symscene/pipeline/pipeline.hpp"

namespace symscene {
namespace {

constexpr std::array methods{GraspMethod::symscene, GraspMethod::cylinders,
                             GraspMethod::true_meshes, GraspMethod::antipodal, GraspMethod::random};
constexpr std::array knowledges{TableKnowledge::none, TableKnowledge::plane, TableKnowledge::scale};

/// Whether the position of a grasp is where the benchmark allows it.
bool is_in_volume(const Eigen::Vector3d& p) {
  constexpr double low = 0.02, high = 0.28, bottom = 0.055, top = 0.3;
  return p.x() >= low && p.x() <= high && p.y() >= low && p.y() <= high && p.z() >= bottom &&
         p.z() <= top;
}

void take_plan(GraspPlan plan, GraspProposals& proposals) {
  proposals.objects = plan.objects.size();
  for (const ObjectGraspSummary& object : plan.objects) {
    if (object.reason) proposals.reasons.emplace_back(to_string(*object.reason));
  }
  proposals.grasps = std::move(plan.grasps);
}

void plan_on_objects(const Scene& scene, const Gripper& gripper,
                     const ClutterMethodOptions& options, GraspProposals& proposals) {
  const SegmentationResult result = segment_scene(scene, options.pipeline);
  const Stopwatch watch;
  take_plan(plan_grasps(grasp_scene(result, &scene, options.grasping), gripper, options.grasping),
            proposals);
  proposals.grasping_seconds = watch.seconds();
}

void plan_on_cylinders(const Scene& scene, const Gripper& gripper, GraspProposals& proposals) {
  const CylinderScene cylinders = fit_cylinders(scene);
  const Stopwatch watch;
  take_plan(cylinder_grasps(cylinders, gripper), proposals);
  proposals.grasping_seconds = watch.seconds();
}

void plan_on_views(GraspMethod method, std::span<const ClutterView> views, const Gripper& gripper,
                   const ClutterMethodOptions& options, GraspProposals& proposals) {
  const Scene scene = sensed_scene(views, options);
  if (scene.cloud.empty()) {
    proposals.reasons = scene.warnings;
    return;
  }
  if (method == GraspMethod::cylinders)
    plan_on_cylinders(scene, gripper, proposals);
  else
    plan_on_objects(scene, gripper, options, proposals);
}

}  // namespace

const char* to_string(GraspMethod method) {
  switch (method) {
    case GraspMethod::symscene:
      return "symscene";
    case GraspMethod::cylinders:
      return "cylinders";
    case GraspMethod::true_meshes:
      return "true-meshes";
    case GraspMethod::antipodal:
      return "antipodal";
    case GraspMethod::random:
      break;
  }
  return "random";
}

GraspMethod parse_grasp_method(const std::string& text) {
  for (const GraspMethod method : methods) {
    if (text == to_string(method)) return method;
  }
  throw InputError("the method", "symscene, cylinders, true-meshes, antipodal or random", text);
}

const char* to_string(TableKnowledge knowledge) {
  switch (knowledge) {
    case TableKnowledge::none:
      return "none";
    case TableKnowledge::plane:
      return "plane";
    case TableKnowledge::scale:
      break;
  }
  return "scale";
}

TableKnowledge parse_table_knowledge(const std::string& text) {
  for (const TableKnowledge knowledge : knowledges) {
    if (text == to_string(knowledge)) return knowledge;
  }
  throw InputError("what is known of the table", "none, plane or scale", text);
}

GraspProposals propose_grasps(GraspMethod method, const ClutterWorld& world,
                              std::span<const ClutterView> views,
                              const ClutterMethodOptions& options, std::uint64_t seed) {
  const Gripper gripper = panda_hand();
  const Stopwatch watch;
  GraspProposals proposals;
  switch (method) {
    case GraspMethod::symscene:
    case GraspMethod::cylinders:
      plan_on_views(method, views, gripper, options, proposals);
      break;
    case GraspMethod::true_meshes:
      take_plan(plan_grasps(true_grasp_scene(world), gripper, options.grasping), proposals);
      break;
    case GraspMethod::antipodal:
      proposals.grasps = random_antipodal_grasps(world, gripper, Random(seed));
      break;
    case GraspMethod::random:
      proposals.grasps = random_grasps(world, gripper, Random(seed));
      break;
  }
  proposals.seconds = watch.seconds();
  if (options.in_volume_only) {
    proposals.outside = std::erase_if(proposals.grasps, [](const Grasp& grasp) {
      return !is_in_volume(grasp.T_world_tool.translation());
    });
  }
  return proposals;
}

}  // namespace symscene
