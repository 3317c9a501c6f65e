#include <nlohmann/json.hpp>

#include "symscene/picking/pick_run.hpp"

namespace symscene {
namespace {

using Json = nlohmann::ordered_json;

Json times_json(const std::vector<StageTime>& times) {
  Json json = Json::object();
  double sum = 0.0;
  for (const StageTime& time : times) {
    json[time.stage] = time.seconds;
    sum += time.seconds;
  }
  json["sum"] = sum;
  return json;
}

Json cleared_json(const PickRun::Cleared& cleared) {
  return {{"placed", cleared.placed}, {"in_bin", cleared.in_bin}};
}

Json look_json(const PickLook& look) {
  return {{"time_s", look.time},
          {"frames", look.frames},
          {"fused", look.fused},
          {"tracking_error_m", look.trajectory.absolute},
          {"robot_share", look.robot_share},
          {"touched", look.touched},
          {"enough_views", look.is_enough},
          {"objects_on_table", look.present},
          {"objects_found", look.found},
          {"grasps", look.grasps},
          {"no_pick", look.no_pick},
          {"wall_times_s", times_json(look.times)}};
}

Json attempt_json(const PickAttempt& attempt) {
  const Eigen::Vector3d position = attempt.grasp.T_world_tool.translation();
  const Eigen::Quaterniond rotation(attempt.grasp.T_world_tool.linear());
  return {{"look", attempt.look},
          {"object", attempt.object},
          {"outcome", to_string(attempt.end)},
          {"detail", attempt.detail},
          {"begin_s", attempt.begin},
          {"end_s", attempt.finish},
          {"grasp",
           {{"source", to_string(attempt.grasp.source)},
            {"quality", attempt.grasp.quality},
            {"opening_m", attempt.grasp.opening},
            {"tool_position_m", {position.x(), position.y(), position.z()}},
            {"tool_rotation_xyzw", {rotation.x(), rotation.y(), rotation.z(), rotation.w()}}}}};
}

template <class Items, class ToJson>
Json array_of(const Items& items, const ToJson& to_json) {
  Json json = Json::array();
  for (const auto& item : items) json.push_back(to_json(item));
  return json;
}

}  // namespace

std::string format_pick_run(const PickRun& run, const std::string& description) {
  const Json json{{"made_by", Json::parse(description)},
                  {"end", to_string(run.end)},
                  {"objects", run.all.placed},
                  {"in_bin", run.all.in_bin},
                  {"graspable", cleared_json(run.graspable)},
                  {"graspable_in_some_pose", cleared_json(run.graspable_in_some_pose)},
                  {"fallen", run.fallen},
                  {"simulated_s", run.duration},
                  {"wall_times_to_first_in_bin_s",
                   run.to_first.empty() ? Json(nullptr) : times_json(run.to_first)},
                  {"looks", array_of(run.looks, look_json)},
                  {"attempts", array_of(run.attempts, attempt_json)},
                  {"left", array_of(run.left,
                                    [](const LeftObject& left) {
                                      return Json{{"object", left.name},
                                                  {"graspable", left.graspable.as_it_lies},
                                                  {"graspable_in_some_pose", left.graspable.at_all},
                                                  {"reason", left.reason}};
                                    })},
                  {"events", array_of(run.recording.events,
                                      [](const RecordedEvent& event) {
                                        return Json{{"time_s", event.time},
                                                    {"outcome", to_string(event.outcome)},
                                                    {"text", event.text}};
                                      })},
                  {"warnings", run.warnings}};
  // Names come from files and may be no UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace symscene
