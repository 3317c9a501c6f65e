#include <algorithm>
#include <memory>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "dataset_resume.hpp"
#include "dataset_tally.hpp"
#include "dataset_worker.hpp"
#include "session.hpp"
#include "symscene/simulation/scanned_models.hpp"

namespace symscene::app {
namespace {

namespace fs = std::filesystem;

constexpr int default_time_limit = 3600;  ///< of a scene [s]

struct Dataset {
  SharedOptions shared;
  DatasetOptions options;
  fs::path dir;  ///< set by resolve_folder()
  std::string split_name = "test";
  fs::path meshes;
  fs::path symmetries;
  std::optional<int> scenes;
  std::optional<int> frames;
  std::optional<int> min_objects;
  std::optional<int> max_objects;
  std::optional<int> time_limit;
  std::optional<std::uint64_t> seed;

  OptionFields configure() {
    return configure_options(options, shared.config, [&] {
      options.scenes = scenes.value_or(options.scenes);
      options.camera.frames = frames.value_or(options.camera.frames);
      options.min_objects = min_objects.value_or(options.min_objects);
      options.max_objects = max_objects.value_or(options.max_objects);
      options.seed = seed.value_or(options.seed);
    });
  }

  /// The folder is DIR, as in earlier versions, or that of -o.
  void resolve_folder() {
    if (dir.empty() && shared.output.empty())
      throw InputError("--output", "a dataset folder to make or to continue", "none");
    if (!dir.empty() && !shared.output.empty())
      throw InputError("--output", "no DIR beside it", dir.string());
    if (dir.empty()) dir = shared.output;
  }

  Split split() const { return parse_split(split_name, "--split"); }

  /// The meshes of this split, as models that can be dropped.
  ModelFolder read_models_of_split() const {
    if (meshes.empty()) {
      if (!symmetries.empty())
        throw InputError("--symmetries", "--meshes, to which the symmetries belong", "none");
      return {};
    }
    if (!has_physics())
      throw InputError("--meshes", "a build with physics (MuJoCo) to drop them", "one without");
    ModelFolder folder = read_models(meshes, symmetries);
    folder.models = droppable(models_of(split(), folder.models));
    if (folder.models.empty())
      throw InputError(meshes.string(), fmt::format("a solid for the {} split", split_name),
                       "none");
    return folder;
  }

  /// dataset.json.
  nlohmann::ordered_json description(const OptionFields& fields,
                                     const std::vector<ObjectModel>& models) const {
    auto all = nlohmann::ordered_json::parse(describe_run("dataset", fields));
    all["split"] = split_name;
    all["models"] = nlohmann::ordered_json::array();
    for (const ObjectModel& model : models) all["models"].push_back(model.name);
    return all;
  }

  void run() {
    const OptionFields fields = configure();
    resolve_folder();
    if (!meshes.empty()) require_not_input(dir, meshes);
    const ModelFolder folder = read_models_of_split();
    begin_dataset_folder(dir, description(fields, folder.models));
    const auto wanted = missing_scenes(dir, static_cast<std::size_t>(options.scenes));
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t processes =
        std::min(wanted.size(), shared.threads == 0 ? cores : shared.threads);
    // The pool forks, so it comes before the session, whose progress line has a thread.
    ProcessPool pool(
        processes,
        [&](std::size_t i) {
          return make_and_write_scene(absolute(dir), options, split(), folder.models, i);
        },
        std::chrono::seconds(time_limit.value_or(default_time_limit)));
    make_missing(wanted, pool, folder.warnings);
  }

  void make_missing(const std::vector<std::size_t>& wanted, ProcessPool& pool,
                    const std::vector<std::string>& warnings) const {
    Session session("dataset", shared);
    session.warn(warnings);
    const auto total = static_cast<std::size_t>(options.scenes);
    const std::size_t before = total - wanted.size();
    if (!has_physics())
      session.print_line("this build has no physics: all objects are arranged, none are dropped");
    if (before > 0) session.print_line(fmt::format("{} of {} scenes exist already", before, total));
    DatasetTally tally(total, wanted.size());
    session.on_begin()(tally.progress());
    pool.run(wanted, [&](const ItemOutcome& outcome) {
      tally.add(outcome, session);
      session.on_begin()(tally.progress());
    });
    const std::vector<std::string>& failed = tally.failed();
    if (!failed.empty())
      throw InputError(dir.string(), fmt::format("{} scenes", total),
                       fmt::format("{}, as {} could not be made", total - failed.size(),
                                   fmt::join(failed, ", ")));
    session.print_line(fmt::format("{}: {} scenes, {} made now with {} objects", dir.string(),
                                   total, wanted.size(), tally.objects()));
    session.finish({{"output", dir}, {"scenes", total}, {"made", wanted.size()}}, tally.stages());
  }
};

}  // namespace

void add_dataset(CommandLine& line) {
  const auto state = std::make_shared<Dataset>();
  Arguments arguments(
      line, "dataset", "Make many simulated, reconstructed scenes with their ground truth",
      "symscene dataset -o scenes --scenes 89 --seed 1\n"
      "  symscene dataset -o scenes --split training --meshes ycb --symmetries ycb.json");
  arguments.optional_input(state->dir, "DIR", "the same as -o DIR");
  arguments.optional_output_folder(state->shared, "dataset folder to make or to continue");
  const DatasetOptions defaults;
  const auto with_default = [](const char* text, int value) {
    return fmt::format("{} (default {})", text, value);
  };
  arguments.count("--scenes", state->scenes, range_of(defaults, "scenes"),
                  with_default("number of scenes", defaults.scenes));
  arguments.choice(
      "--split", state->split_name, {"training", "test"},
      "split to make: the two share no seeds and no meshes (default: " + state->split_name + ")");
  arguments.folder("--meshes", state->meshes,
                   "drop the split's half of the meshes in this folder among household objects");
  arguments.file("--symmetries", state->symmetries, "JSON file with the symmetries of the meshes");
  arguments.count("--min-objects", state->min_objects, range_of(defaults, "min_objects"),
                  with_default("fewest objects per scene", defaults.min_objects));
  arguments.count("--max-objects", state->max_objects, range_of(defaults, "max_objects"),
                  with_default("most objects per scene", defaults.max_objects));
  arguments.count("--frames", state->frames, range_of(defaults, "camera.frames"),
                  with_default("frames per sweep", defaults.camera.frames));
  arguments.count(
      "--time-limit", state->time_limit, between(1, 1e6),
      with_default("seconds after which a scene is given up, with its process of --threads, "
                   "as it is stopped or hangs",
                   default_time_limit));
  arguments.seed(state->seed, defaults.seed);
  arguments.run_stages(state);
}

}  // namespace symscene::app
