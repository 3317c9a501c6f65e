#include "gripper_json.hpp"
#include "io/pose_json.hpp"
#include "symscene/io/grasps.hpp"

namespace symscene {
namespace {

constexpr const char* plan_to_write = "grasps to write";
constexpr std::size_t version = 1;

Json grasp_json(const Grasp& grasp, const Gripper& gripper) {
  Json json = {{"object", grasp.object},
               {"quality", to_json(grasp.quality, plan_to_write)},
               {"opening_m", to_json(grasp.opening, plan_to_write)},
               {"source", to_string(grasp.source)},
               {"T_world_tool", pose_json(grasp.T_world_tool, plan_to_write)},
               {"T_world_wrist",
                pose_json(grasp.T_world_tool * gripper.T_wrist_tool.inverse(), plan_to_write)}};
  Json features = Json::object();
  GraspFeatures::visit_fields(grasp.features, [&](const char* name, double value) {
    features[name] = to_json(value, plan_to_write);
  });
  json["features"] = features;
  return json;
}

Json rejection_json(const RejectedGrasp& rejected) {
  return {{"object", rejected.grasp.object},
          {"reason", to_string(rejected.reason)},
          {"value", to_json(rejected.value, plan_to_write)},
          {"bound", to_json(rejected.bound, plan_to_write)},
          {"source", to_string(rejected.grasp.source)},
          {"T_world_tool", pose_json(rejected.grasp.T_world_tool, plan_to_write)}};
}

Json counts_json(const ObjectGraspSummary& object) {
  Json counts = Json::object();
  for (std::size_t i = 0; i < object.rejected.size(); ++i) {
    if (object.rejected[i] > 0)
      counts[to_string(static_cast<GraspRejection>(i))] = object.rejected[i];
  }
  return counts;
}

Json object_json(std::size_t id, const ObjectGraspSummary& object) {
  Json json = {{"id", id}, {"candidates", object.candidates}, {"grasps", object.grasps}};
  if (object.reason) json["reason"] = to_string(*object.reason);
  json["rejected"] = counts_json(object);
  return json;
}

}  // namespace

std::string format_grasps_json(const GraspPlan& plan, const Gripper& gripper, bool with_timings) {
  Json json = {{"version", version}, {"gripper", gripper_json(gripper, plan_to_write)}};
  json["grasps"] = Json::array();
  for (const Grasp& grasp : plan.grasps) json["grasps"].push_back(grasp_json(grasp, gripper));
  json["objects"] = Json::array();
  for (std::size_t id = 0; id < plan.objects.size(); ++id)
    json["objects"].push_back(object_json(id, plan.objects[id]));
  json["rejected"] = Json::array();
  for (const RejectedGrasp& rejected : plan.rejected)
    json["rejected"].push_back(rejection_json(rejected));
  if (with_timings) {
    json["timings"] = Json::object();
    for (const StageTime& stage : plan.timings)
      json["timings"][stage.stage] = to_json(stage.seconds, plan_to_write);
  }
  return format_json(json) + "\n";
}

}  // namespace symscene
