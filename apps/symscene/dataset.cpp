#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "core/process_pool.hpp"
#include "io/atomic_file.hpp"
#include "session.hpp"
#include "symscene/dataset/dataset_folder.hpp"
#include "symscene/dataset/scene_maker.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/simulation/scanned_models.hpp"

namespace symscene::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// What scene.json says of a scene: nothing that differs when it is made again.
std::string scene_description(const SceneFacts& facts) {
  Json failed = Json::array();
  for (const FailedAttempt& attempt : facts.failed)
    failed.push_back({{"seed", attempt.seed}, {"reason", attempt.reason}});
  const Json description = {{"version", 1},
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
  return description.dump(2) + "\n";
}

std::string reasons(const SceneFacts& facts) {
  std::vector<std::string> lines;
  for (const FailedAttempt& attempt : facts.failed)
    lines.push_back(fmt::format("with seed {} {}", attempt.seed, attempt.reason));
  return fmt::format("{}", fmt::join(lines, ", "));
}

/// Without one of these a scene is made again.
constexpr std::array scene_files{"scene.json", "cloud.ply", "truth.json"};

/// Makes and writes a scene in a process of its own; what there is to say of it, as JSON.
std::string make_and_write(const fs::path& dir, const DatasetOptions& options, Split split,
                           const std::vector<ObjectModel>& models, std::size_t index) {
  const ThreadLimit one(1);
  Json warnings = Json::array();
  set_log_sink([&](LogLevel level, std::string_view message) {
    if (level == LogLevel::warning) warnings.push_back(message);
  });
  const MadeScene made = make_scene(options, split, models, index);
  set_log_sink({});
  if (!made.facts.good)
    throw std::runtime_error(
        fmt::format("no seed made a good scene of it: {}", reasons(made.facts)));
  if (!made.facts.failed.empty())
    warnings.push_back(fmt::format("another seed was taken: {}", reasons(made.facts)));
  const SignalDelay whole;
  write_scene(scene_folder(dir, index), made.scene,
              {.scene_json = scene_description(made.facts), .truth = &made.truth});
  Json stages = Json::array();
  for (const StageTime& time : made.stages) stages.push_back({time.stage, time.seconds});
  return Json{{"objects", made.facts.objects_seen}, {"warnings", warnings}, {"stages", stages}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string duration(double seconds) {
  if (seconds < 90.0) return fmt::format("{:.0f} s", std::ceil(seconds));
  if (seconds < 5400.0) return fmt::format("{:.0f} min", std::ceil(seconds / 60.0));
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

/// The first option that two descriptions of datasets differ in, with its values.
std::string first_difference(const Json& wanted, const Json& found) {
  const Json a = wanted.flatten();
  const Json b = found.flatten();
  for (const auto& [key, value] : a.items()) {
    const std::string was = b.contains(key) ? b[key].dump() : "nothing";
    if (was != value.dump())
      return fmt::format("{} {} in place of {}", key.substr(1), was, value.dump());
  }
  for (const auto& [key, value] : b.items()) {
    if (!a.contains(key)) return fmt::format("{} {}", key.substr(1), value.dump());
  }
  return "";
}

/// A scene does not depend on how many others there are, so that a dataset may grow. Whether it
/// does.
bool make_as_long(Json& description, int scenes) {
  const Json::json_pointer place("/options/scenes");
  if (!description.contains(place) || !description[place].is_number_integer()) return false;
  if (description[place].get<long long>() >= scenes) return false;
  description[place] = scenes;
  return true;
}

/// What has come of the scenes so far.
struct Tally {
  Tally(std::size_t total_scenes, std::size_t wanted_scenes)
      : total(total_scenes), wanted(wanted_scenes) {}

  std::size_t total;   ///< of the dataset
  std::size_t wanted;  ///< to be made now
  std::size_t finished = 0;
  std::size_t objects = 0;
  std::vector<std::string> failed;
  std::vector<StageTime> stages;  ///< summed over scenes
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();

  void add(const ItemOutcome& outcome, Session& session) {
    ++finished;
    const std::string name = fmt::format("{:04}", outcome.item);
    const auto warn = [&](const std::string& text) {
      session.warn(fmt::format("scene {}: {}", name, text));
    };
    if (!outcome.done) {
      failed.push_back(name);
      warn(outcome.text);
      return;
    }
    const Json report = Json::parse(outcome.text);
    objects += report.at("objects").get<std::size_t>();
    for (const Json& warning : report.at("warnings")) warn(warning.get<std::string>());
    for (const Json& time : report.at("stages"))
      add_time(time.at(0).get<std::string>(), time.at(1).get<double>());
  }

  /// "scene 12 of 89, 8 min left"
  std::string progress() const {
    std::string scene =
        fmt::format("scene {} of {}", std::min(total, total - wanted + finished + 1), total);
    if (finished == 0) return scene;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    const double share = static_cast<double>(wanted - finished) / static_cast<double>(finished);
    return fmt::format("{}, {} left", scene, duration(share * elapsed.count()));
  }

 private:
  void add_time(const std::string& stage, double seconds) {
    auto own = std::find_if(stages.begin(), stages.end(),
                            [&](const StageTime& time) { return time.stage == stage; });
    if (own == stages.end()) own = stages.insert(stages.end(), {stage, 0.0});
    own->seconds += seconds;
  }
};

struct Dataset {
  SharedOptions shared;
  DatasetOptions options;
  fs::path dir;
  std::string split_name = "test";
  fs::path meshes;
  fs::path symmetries;
  std::optional<int> scenes;
  std::optional<int> frames;
  std::optional<int> min_objects;
  std::optional<int> max_objects;
  std::optional<std::uint64_t> seed;

  OptionFields configure() {
    OptionFields fields = option_fields(options);
    if (!shared.config.empty()) read_config(shared.config, fields);
    options.scenes = scenes.value_or(options.scenes);
    options.camera.frames = frames.value_or(options.camera.frames);
    options.min_objects = min_objects.value_or(options.min_objects);
    options.max_objects = max_objects.value_or(options.max_objects);
    options.seed = seed.value_or(options.seed);
    options.validate();
    return fields;
  }

  Split split() const { return parse_split(split_name, "--split"); }

  std::vector<ObjectModel> read_own_models() const {
    if (meshes.empty()) {
      if (!symmetries.empty())
        throw InputError("--symmetries", "--meshes, whose symmetries they are", "none");
      return {};
    }
    if (!has_physics())
      throw InputError("--meshes", "a build with physics (MuJoCo) to drop them", "one without");
    std::vector<ObjectModel> own = droppable(models_of(split(), read_models(meshes, symmetries)));
    if (own.empty())
      throw InputError(meshes.string(), fmt::format("a solid for the {} split", split_name),
                       "none");
    return own;
  }

  Json description(const OptionFields& fields, const std::vector<ObjectModel>& models) const {
    Json all = Json::parse(describe_run("dataset", fields));
    all["split"] = split_name;
    all["models"] = Json::array();
    for (const ObjectModel& model : models) all["models"].push_back(model.name);
    return all;
  }

  /// Begins a dataset, or goes on with one that was made with the same options.
  void begin_folder(const Json& wanted) const {
    const fs::path file = dir / dataset_file;
    if (!fs::exists(file)) {
      if (fs::exists(dir) && (!fs::is_directory(dir) || !fs::is_empty(dir)))
        throw InputError(dir.string(), "a new or an empty folder, or a dataset to go on with",
                         fs::is_directory(dir) ? "a folder with other files" : "a file");
      fs::create_directories(dir);
      write_file_atomically(file, wanted.dump(2) + "\n");
      return;
    }
    Json found = Json::parse(read_file(file), nullptr, false);
    if (found.is_discarded()) throw InputError(file.string(), "JSON", "a mistake in it");
    // Datasets made earlier name the splits "tune" and "report".
    if (found.contains("split") && found["split"].is_string())
      found["split"] = to_string(parse_split(found["split"].get<std::string>(), file.string()));
    const bool grows = make_as_long(found, options.scenes);
    const std::string difference = first_difference(wanted, found);
    if (!difference.empty())
      throw InputError(file.string(), "a dataset made with the same options", difference);
    if (grows) write_file_atomically(file, wanted.dump(2) + "\n");
  }

  std::vector<std::size_t> missing() const {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < static_cast<std::size_t>(options.scenes); ++i) {
      const fs::path scene = scene_folder(dir, i);
      const bool is_whole = std::all_of(scene_files.begin(), scene_files.end(),
                                        [&](const char* file) { return fs::exists(scene / file); });
      if (!is_whole) indices.push_back(i);
    }
    return indices;
  }

  void run() {
    const OptionFields fields = configure();
    if (!meshes.empty()) require_not_input(dir, meshes);
    const std::vector<ObjectModel> models = read_own_models();
    begin_folder(description(fields, models));
    const std::vector<std::size_t> wanted = missing();
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t processes =
        std::min(wanted.size(), shared.threads == 0 ? cores : shared.threads);
    // Before the session, whose progress line is drawn by a thread.
    ProcessPool pool(processes, [&](std::size_t i) {
      return make_and_write(absolute(dir), options, split(), models, i);
    });
    make_missing(wanted, pool);
  }

  void make_missing(const std::vector<std::size_t>& wanted, ProcessPool& pool) const {
    Session session("dataset", shared);
    const auto total = static_cast<std::size_t>(options.scenes);
    const std::size_t before = total - wanted.size();
    if (!has_physics()) session.say("without physics all objects are arranged, none is dropped");
    if (before > 0) session.say(fmt::format("{} of {} scenes are there already", before, total));
    Tally tally(total, wanted.size());
    session.on_begin()(tally.progress());
    pool.run(wanted, [&](const ItemOutcome& outcome) {
      tally.add(outcome, session);
      session.on_begin()(tally.progress());
    });
    if (!tally.failed.empty())
      throw InputError(dir.string(), fmt::format("{} scenes", total),
                       fmt::format("{}, as {} could not be made", total - tally.failed.size(),
                                   fmt::join(tally.failed, ", ")));
    session.say(fmt::format("{}: {} scenes, {} made now with {} objects", dir.string(), total,
                            wanted.size(), tally.objects));
    session.finish({{"output", dir}, {"scenes", total}, {"made", wanted.size()}}, tally.stages);
  }
};

}  // namespace

void add_dataset(CLI::App& app) {
  const auto state = std::make_shared<Dataset>();
  Arguments arguments(
      app, "dataset", "Make many simulated, reconstructed scenes with the truth beside",
      "symscene dataset scenes --scenes 89 --seed 1\n"
      "  symscene dataset scenes --split training --meshes ycb --symmetries ycb.json");
  arguments.input(state->dir, "DIR", "dataset folder to make, or to go on with");
  arguments.count("--scenes", state->scenes, "how many scenes (default 89)");
  arguments.choice("--split", state->split_name, {"training", "test"},
                   "what the scenes are for: the two share no seeds and no meshes (default: test)");
  arguments.folder("--meshes", state->meshes,
                   "drop the split's half of this folder's meshes among household objects");
  arguments.file("--symmetries", state->symmetries, "JSON file with the symmetries of the meshes");
  arguments.count("--min-objects", state->min_objects, "fewest objects of a scene (default 1)");
  arguments.count("--max-objects", state->max_objects, "most objects of a scene (default 15)");
  arguments.count("--frames", state->frames, "frames of a sweep (default 150)");
  arguments.seed(state->seed);
  arguments.threads(state->shared);
  arguments.reporting(state->shared);
  arguments.config(state->shared, [state] { return state->configure(); });
  arguments.run([state] { state->run(); });
}

}  // namespace symscene::app
