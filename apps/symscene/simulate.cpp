#include <memory>
#include <optional>

#include <fmt/format.h>

#include "commands.hpp"
#include "session.hpp"
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

  void run() {
    const OptionFields fields = configure();
    Session session("simulate", shared);
    StageTimer timer(session.on_begin());
    const SimulatedScene simulated =
        timer.time("simulate", [&] { return simulate_tabletop(options); });
    timer.time("write", [&] {
      write_scene(absolute(shared.output), simulated.scene, describe_run("simulate", fields),
                  &simulated.truth);
    });
    const Index points = simulated.scene.cloud.size();
    const std::size_t count = simulated.truth.objects.size();
    session.say(fmt::format("{}: {} objects, {} points", shared.output.string(), count, points));
    session.finish({{"output", shared.output}, {"objects", count}, {"points", points}},
                   timer.stages());
  }
};

}  // namespace

void add_simulate(CLI::App& app) {
  const auto state = std::make_shared<Simulate>();
  Arguments arguments(app, "simulate", "Scan a simulated table with objects, with the truth beside",
                      "symscene simulate -o scene --objects 6 --seed 1");
  arguments.required_output(state->shared, "scene folder to write");
  arguments.count("--objects", state->objects, "objects on the table (default 6)");
  arguments.seed(state->seed);
  arguments.threads(state->shared);
  arguments.reporting(state->shared);
  arguments.config(state->shared, [state] { return state->configure(); });
  arguments.run([state] { state->run(); });
}

}  // namespace symscene::app
