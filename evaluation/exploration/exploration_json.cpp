#include "io/pose_json.hpp"
#include "io/view_json.hpp"
#include "symscene/exploration/exploration_output.hpp"

namespace symscene {
namespace {

constexpr const char* to_write = "exploration to write";

Json gain_json(const ViewGain& gain) {
  return {{"total", gain.total()},
          {"inferred", gain.inferred},
          {"disputed", gain.disputed},
          {"unknown", gain.unknown}};
}

/// The best of the candidates that were not visited; null without.
Json best_json(const NextViews& views) {
  if (views.ranked.empty()) return nullptr;
  const RankedView& best = views.ranked.front();
  return {{"candidate", best.candidate}, {"gain_m2", gain_json(best.gain)}};
}

Json known_json(const ExploredView& view) {
  return {{"objects", view.objects.size()},
          {"objects_correct", view.step.masks.correct},
          {"observed", view.step.observed},
          {"completed", view.step.completed},
          {"inferred_area_m2", view.expected.inferred_area},
          {"object_area_m2", view.expected.object_area},
          {"unknown_area_m2", view.expected.unknown_area}};
}

Json view_json(const ExploredView& view) {
  return {{"candidate", view.step.view},
          {"T_world_camera", pose_json(view.T_world_camera, to_write)},
          {"gain", view.step.gain ? gain_json(*view.step.gain) : Json(nullptr)},
          {"known", known_json(view)},
          {"expected", best_json(view.expected)},
          {"timings", stage_times_json(view.timings)}};
}

Json views_json(const TableExploration& exploration) {
  Json views = Json::array();
  for (const ExploredView& view : exploration.views) views.push_back(view_json(view));
  return views;
}

Json left_json(const NextViews& left) {
  Json objects = Json::array();
  for (std::size_t k = 0; k < left.areas.size(); ++k)
    objects.push_back({{"object", k},
                       {"inferred_area_m2", left.areas[k].inferred},
                       {"area_m2", left.areas[k].all}});
  return {{"inferred_area_m2", left.inferred_area},
          {"object_area_m2", left.object_area},
          {"unknown_area_m2", left.unknown_area},
          {"objects", std::move(objects)},
          {"best_view", best_json(left)}};
}

Json truth_json(const TableExploration& exploration, const Tabletop& table) {
  Json objects = Json::array();
  for (std::size_t k = 0; k < table.objects.size(); ++k)
    objects.push_back({{"name", table.objects[k].object.name}, {"observed", exploration.seen[k]}});
  return objects;
}

Json candidates_json(const std::vector<Eigen::Isometry3d>& poses) {
  Json candidates = Json::array();
  for (const Eigen::Isometry3d& pose : poses) candidates.push_back(pose_json(pose, to_write));
  return candidates;
}

}  // namespace

std::string format_exploration_json(const TableExploration& exploration, const Tabletop& table,
                                    const std::string& description) {
  const auto policy = ranking_policy(exploration.policy);
  const Json unit = !policy                           ? Json(nullptr)
                    : *policy == ViewPolicy::symmetry ? Json("m2")
                                                      : Json("voxels");
  const Json json{{"version", 1},
                  {"made_by", Json::parse(description)},
                  {"policy", to_string(exploration.policy)},
                  {"gain_unit", unit},
                  {"end", to_string(exploration.end)},
                  {"camera", camera_json(exploration.camera)},
                  {"true_objects", truth_json(exploration, table)},
                  {"views", views_json(exploration)},
                  {"left_unknown", left_json(exploration.left())},
                  {"candidates", candidates_json(exploration.candidates)}};
  // Names come from files and may be no UTF-8.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace symscene
