#include <algorithm>

#include <fmt/format.h>

#include "gripper_json.hpp"
#include "io/atomic_file.hpp"
#include "io/pose_json.hpp"
#include "symscene/io/grasps.hpp"

namespace symscene {
namespace {

constexpr std::size_t grasps_version = 1;

/// The enumerator below `count` of that name; fails with `what` if there is none.
template <class Enum>
Enum named(const JsonCursor& json, std::size_t count, const char* what) {
  const std::string name = json.string();
  for (std::size_t i = 0; i < count; ++i) {
    if (name == to_string(static_cast<Enum>(i))) return static_cast<Enum>(i);
  }
  json.fail(what);
}

double number_from_0(const JsonCursor& json, double most, const char* expected) {
  const double value = json.number();
  if (!(value >= 0.0 && value <= most)) json.fail(expected);
  return value;
}

int object_of(const JsonCursor& json, std::size_t objects) {
  const std::size_t object = json.count();
  if (object >= objects) json.fail(fmt::format("an object below {}, as listed", objects));
  return static_cast<int>(object);
}

GraspFeatures features_of(const JsonCursor& json) {
  GraspFeatures features;
  GraspFeatures::visit_fields(
      features, [&](const char* name, double& value) { value = json.at(name).number(); });
  return features;
}

GraspSource source_of(const JsonCursor& json) {
  return named<GraspSource>(json.at("source"), grasp_sources, "the source of a grasp");
}

Grasp grasp_of(const JsonCursor& json, std::size_t objects, const Gripper& gripper) {
  Grasp grasp;
  grasp.object = object_of(json.at("object"), objects);
  grasp.quality = number_from_0(json.at("quality"), 1.0, "a quality in [0, 1]");
  grasp.opening = number_from_0(json.at("opening_m"), gripper.max_opening,
                                "an opening that the gripper has [m]");
  grasp.source = source_of(json);
  grasp.T_world_tool = pose_of(json.at("T_world_tool"));
  if (const auto features = json.find("features")) grasp.features = features_of(*features);
  return grasp;
}

GraspRejection reason_of(const JsonCursor& json) {
  return named<GraspRejection>(json, grasp_rejections, "the reason of a rejection");
}

RejectedGrasp rejected_of(const JsonCursor& json, std::size_t objects) {
  RejectedGrasp rejected;
  rejected.grasp.object = object_of(json.at("object"), objects);
  rejected.grasp.source = source_of(json);
  rejected.grasp.T_world_tool = pose_of(json.at("T_world_tool"));
  rejected.reason = reason_of(json.at("reason"));
  rejected.value = json.at("value").number();
  rejected.bound = json.at("bound").number();
  return rejected;
}

ObjectGraspSummary summary_of(const JsonCursor& json, std::size_t id) {
  if (json.at("id").count() != id) json.at("id").fail(std::to_string(id));
  ObjectGraspSummary summary;
  summary.candidates = json.at("candidates").count();
  summary.grasps = json.at("grasps").count();
  if (const auto reason = json.find("reason")) summary.reason = reason_of(*reason);
  if (const auto rejected = json.find("rejected")) {
    for (std::size_t i = 0; i < grasp_rejections; ++i) {
      if (const auto count = rejected->find(to_string(static_cast<GraspRejection>(i))))
        summary.rejected[i] = count->count();
    }
  }
  return summary;
}

}  // namespace

GraspFile parse_grasps_json(std::string_view text, const std::string& name) {
  const Json document = parse_json(text, name);
  const JsonCursor root(document, name);
  if (root.at("version").count() != grasps_version)
    root.at("version").fail(std::to_string(grasps_version));
  GraspFile file;
  file.gripper = gripper_of(root.at("gripper"));
  GraspPlan& plan = file.plan;
  for (const JsonCursor& object : root.at("objects").items())
    plan.objects.push_back(summary_of(object, plan.objects.size()));
  const std::size_t objects = plan.objects.size();
  for (const JsonCursor& grasp : root.at("grasps").items())
    plan.grasps.push_back(grasp_of(grasp, objects, file.gripper));
  std::stable_sort(plan.grasps.begin(), plan.grasps.end(),
                   [](const Grasp& a, const Grasp& b) { return a.quality > b.quality; });
  if (const auto rejected = root.find("rejected")) {
    for (const JsonCursor& item : rejected->items())
      plan.rejected.push_back(rejected_of(item, objects));
  }
  if (const auto timings = root.find("timings")) {
    for (const auto& [stage, seconds] : timings->members())
      plan.timings.push_back({stage, seconds.number()});
  }
  return file;
}

GraspFile read_grasps(const std::filesystem::path& path) {
  return parse_grasps_json(read_file(path), path.string());
}

}  // namespace symscene
