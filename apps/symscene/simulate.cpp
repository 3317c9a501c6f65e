#include <memory>
#include <optional>

#include <fmt/format.h>

#include "commands.hpp"
#include "common.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/simulation/simulation.hpp"

namespace symscene::app {
namespace {

struct Simulate {
  SharedOptions shared;
  SimulationOptions options;
  std::optional<int> objects;
  std::optional<std::uint64_t> seed;

  OptionFields configure() {
    OptionFields fields = option_fields(options);
    if (!shared.config.empty()) read_config(shared.config, fields);
    options.tabletop.objects = objects.value_or(options.tabletop.objects);
    options.tabletop.seed = seed.value_or(options.tabletop.seed);
    options.validate();
    return fields;
  }

  /// The text of scene.json: what made the scene.
  static std::string scene_json(const OptionFields& fields) {
    const nlohmann::ordered_json json = {{"version", 1},
                                         {"symscene", SYMSCENE_VERSION},
                                         {"command", "simulate"},
                                         {"options", config_values(fields)}};
    return json.dump(2) + "\n";
  }

  void run() {
    const OptionFields fields = configure();
    Session session("simulate", shared);
    StageTimer timer(session.on_begin());
    const SimulatedScene simulated =
        timer.time("simulate", [&] { return simulate_tabletop(options); });
    timer.time("write", [&] {
      write_scene(absolute(shared.output), simulated.scene, scene_json(fields), &simulated.truth);
    });
    const Index points = simulated.scene.cloud.size();
    const std::size_t count = simulated.truth.objects.size();
    session.say(fmt::format("{}: {} objects, {} points", shared.output.string(), count, points));
    session.finish({{"output", shared.output.string()}, {"objects", count}, {"points", points}},
                   timer.stages());
  }
};

}  // namespace

void add_simulate(CLI::App& app) {
  CLI::App& command =
      *app.add_subcommand("simulate", "Scan a simulated table with objects, with the truth beside");
  const auto state = std::make_shared<Simulate>();
  add_output(command, state->shared, "scene folder to write")->required();
  command.add_option("--objects", state->objects, "objects on the table (default 6)")
      ->type_name("N");
  command.add_option("--seed", state->seed, "seed of everything random (default 1)")
      ->type_name("S")
      ->check([](const std::string& text) {
        return text.starts_with('-') ? "expected a whole number from 0, found " + text : "";
      });
  add_threads(command, state->shared);
  add_reporting(command, state->shared);
  add_config(command, state->shared, [state] { return state->configure(); });
  set_example(command, "symscene simulate -o scene --objects 6 --seed 1");
  command.callback([state] { state->run(); });
}

}  // namespace symscene::app
