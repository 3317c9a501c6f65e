#include "grasp_payload.hpp"

#include <map>

#include "encoding.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

using nlohmann::json;

// Shown per object, and per object and reason; the summaries count all.
constexpr std::size_t most_grasps = 50;
constexpr std::size_t most_rejected = 12;

/// Ten micrometres are enough for the eye, and keep the page small.
json rounded(const Eigen::Vector3d& vector) { return encode((1e5 * vector.array()).round() / 1e5); }

json gripper_payload(const Gripper& gripper) {
  return {{"name", gripper.name},
          {"kind", to_string(gripper.kind)},
          {"max_opening", gripper.max_opening},
          {"finger_depth", gripper.finger_depth},
          {"finger_width", gripper.finger_width},
          {"finger_thickness", gripper.finger_thickness},
          {"tip_thickness", gripper.tip_thickness},
          {"finger_spacing", gripper.finger_spacing},
          {"palm_size", encode(gripper.palm_size)}};
}

/// The tool's y and z axes are the closing and the approach direction.
json to_json(const Grasp& grasp) {
  return {{"object", grasp.object},
          {"position", rounded(grasp.T_world_tool.translation())},
          {"closing", rounded(grasp.T_world_tool.linear().col(1))},
          {"approach", rounded(grasp.T_world_tool.linear().col(2))},
          {"opening", grasp.opening},
          {"quality", grasp.quality},
          {"source", to_string(grasp.source)}};
}

json to_json(const RejectedGrasp& rejected) {
  json result = to_json(rejected.grasp);
  result["reason"] = to_string(rejected.reason);
  result["value"] = rejected.value;
  result["bound"] = rejected.bound;
  return result;
}

json to_json(const ObjectGraspSummary& summary) {
  json counts = json::object();
  for (std::size_t k = 0; k < grasp_rejections; ++k) {
    if (summary.rejected[k] != 0)
      counts[to_string(static_cast<GraspRejection>(k))] = summary.rejected[k];
  }
  return {{"candidates", summary.candidates},
          {"grasps", summary.grasps},
          {"rejected", counts},
          {"reason", summary.reason ? json(to_string(*summary.reason)) : json(nullptr)}};
}

/// The best of each object: they are sorted.
json accepted_payload(const std::vector<Grasp>& all) {
  std::map<int, std::size_t> counts;
  json list = json::array();
  for (const Grasp& grasp : all) {
    if (counts[grasp.object]++ < most_grasps) list.push_back(to_json(grasp));
  }
  return list;
}

/// The first of each object and reason.
json rejected_payload(const std::vector<RejectedGrasp>& all) {
  std::map<std::pair<int, GraspRejection>, std::size_t> counts;
  json list = json::array();
  for (const RejectedGrasp& rejected : all) {
    if (counts[{rejected.grasp.object, rejected.reason}]++ < most_rejected)
      list.push_back(to_json(rejected));
  }
  return list;
}

json meanings() {
  json texts = json::object();
  for (std::size_t k = 0; k < grasp_rejections; ++k) {
    const auto reason = static_cast<GraspRejection>(k);
    texts[to_string(reason)] = description(reason);
  }
  return texts;
}

void require_shown(const Grasp& grasp, std::size_t objects) {
  if (grasp.object < 0 || static_cast<std::size_t>(grasp.object) >= objects)
    throw InputError("the page", "grasps of its " + std::to_string(objects) + " objects",
                     "one of object " + std::to_string(grasp.object));
  if (!grasp.T_world_tool.matrix().allFinite())
    throw InputError("the page", "finite poses of grasps", "one that is not finite");
}

void require_consistent(const GraspPlan& plan, std::size_t objects) {
  if (plan.objects.size() != objects)
    throw InputError("the page", std::to_string(objects) + " summaries of grasps, one per object",
                     std::to_string(plan.objects.size()));
  for (const Grasp& grasp : plan.grasps) require_shown(grasp, objects);
  for (const RejectedGrasp& rejected : plan.rejected) require_shown(rejected.grasp, objects);
}

}  // namespace

json grasp_payload(const std::optional<PageGrasps>& grasps, std::size_t objects) {
  if (!grasps) return nullptr;
  const GraspPlan& plan = grasps->plan;
  require_consistent(plan, objects);
  json summaries = json::array();
  for (const ObjectGraspSummary& summary : plan.objects) summaries.push_back(to_json(summary));
  return {{"gripper", gripper_payload(grasps->gripper)},
          {"accepted", accepted_payload(plan.grasps)},
          {"rejected", rejected_payload(plan.rejected)},
          {"objects", std::move(summaries)},
          {"meanings", meanings()}};
}

}  // namespace symscene
