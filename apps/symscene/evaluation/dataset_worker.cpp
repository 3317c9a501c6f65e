#include "dataset_worker.hpp"

#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "core/process_pool.hpp"
#include "symscene/core/thread_limit.hpp"
#include "symscene/dataset/dataset_folder.hpp"
#include "symscene/ground_truth/truth_file.hpp"
#include "symscene/io/scene.hpp"

namespace symscene::app {
namespace {

using Json = nlohmann::ordered_json;

/// What was drawn for the scene.
Json plan_description(const ScenePlan& plan) {
  const SensorNoiseOptions& sensor = plan.sweep.sensor;
  const CameraArcOptions& camera = plan.sweep.camera;
  const TableOptions& table = plan.sweep.tabletop.table;
  return {{"sensor", sensor.model},
          {"noise", plan.noise},
          {"missing_lines", sensor.missing_lines},
          {"width", camera.width},
          {"height", camera.height},
          {"focal_length", camera.focal_length},
          {"frames", camera.frames},
          {"poses", plan.making.poses},
          {"arc", camera.arc},
          {"distance", camera.radius},
          {"elevation", {camera.min_elevation, camera.max_elevation}},
          {"table", {table.length, table.width}},
          {"table_height", table.height},
          {"wall_distance", table.wall_distance},
          {"occupancy", plan.with_occupancy}};
}

/// scene.json: nothing that differs when the scene is made again.
std::string scene_description(const SceneFacts& facts) {
  Json failed = Json::array();
  for (const FailedAttempt& attempt : facts.failed)
    failed.push_back({{"seed", attempt.seed}, {"reason", attempt.reason}});
  Json description = {{"version", 1},
                      {"symscene", SYMSCENE_VERSION},
                      {"command", "dataset"},
                      {"index", facts.index},
                      {"split", to_string(facts.split)},
                      {"seed", facts.seed},
                      {"placement", facts.dropped ? "dropped" : "arranged"},
                      {"objects_asked", facts.objects_asked},
                      {"objects_placed", facts.objects_placed},
                      {"objects_seen", facts.objects_seen},
                      {"frames", {{"count", facts.frames}, {"fused", facts.fused}}},
                      {"path_error", facts.path_error},
                      {"failed_seeds", failed}};
  if (facts.plan) description["drawn"] = plan_description(*facts.plan);
  return description.dump(2) + "\n";
}

std::string failed_seeds(const SceneFacts& facts) {
  std::vector<std::string> seeds;
  for (const FailedAttempt& attempt : facts.failed)
    seeds.push_back(fmt::format("seed {}: {}", attempt.seed, attempt.reason));
  return fmt::format("{}", fmt::join(seeds, ", "));
}

std::string report_text(const MadeScene& made, const std::vector<std::string>& warnings) {
  Json stages = Json::array();
  for (const StageTime& time : made.stages) stages.push_back({time.stage, time.seconds});
  const Json report = {
      {"objects", made.facts.objects_seen}, {"warnings", warnings}, {"stages", stages}};
  return report.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string make_and_write_scene(const std::filesystem::path& dir, const DatasetOptions& options,
                                 Split split, std::span<const ObjectModel> models,
                                 std::size_t index) {
  const ThreadLimit one(1);
  const MadeScene made = make_scene(options, split, models, index);
  std::vector<std::string> warnings = made.warnings;
  if (!made.facts.good)
    throw std::runtime_error(
        fmt::format("no seed made a good scene ({})", failed_seeds(made.facts)));
  if (!made.facts.failed.empty())
    warnings.push_back(fmt::format("another seed was used ({})", failed_seeds(made.facts)));
  const SignalDelay complete_or_absent;
  write_scene(
      scene_folder(dir, index), made.scene,
      {.scene_json = scene_description(made.facts), .truth_json = format_truth(made.truth)});
  return report_text(made, warnings);
}

SceneReport parse_report(const std::string& text) {
  const Json json = Json::parse(text);
  SceneReport report;
  report.objects = json.at("objects").get<std::size_t>();
  for (const Json& warning : json.at("warnings"))
    report.warnings.push_back(warning.get<std::string>());
  for (const Json& time : json.at("stages"))
    report.stages.push_back({time.at(0).get<std::string>(), time.at(1).get<double>()});
  return report;
}

}  // namespace symscene::app
