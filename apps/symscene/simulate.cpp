#include <memory>
#include <optional>

#include <fmt/format.h>

#include "commands.hpp"
#include "session.hpp"
#include "symscene/io/ply.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/io/sequence.hpp"
#include "symscene/io/truth.hpp"
#include "symscene/simulation/scanned_models.hpp"
#include "symscene/simulation/simulation.hpp"
#include "symscene/simulation/sweep.hpp"

namespace symscene::app {
namespace {

/// A fused scene, or with --sequence the depth frames of a sweep that it could be fused from.
struct Simulate {
  SharedOptions shared;
  SimulationOptions scan;
  DropOptions scan_drop;
  SweepOptions sweep;
  bool sequence = false;
  std::filesystem::path meshes;
  std::filesystem::path symmetries;
  std::optional<int> objects;
  std::optional<int> frames;
  std::optional<std::uint64_t> seed;

  TabletopOptions& tabletop() { return sequence ? sweep.tabletop : scan.tabletop; }
  CameraArcOptions& camera() { return sequence ? sweep.camera : scan.camera; }
  const DropOptions& drop() const { return sequence ? sweep.drop : scan_drop; }

  OptionFields configure() {
    OptionFields fields = sequence ? option_fields(sweep) : option_fields(scan);
    if (!sequence) DropOptions::visit_fields(scan_drop, FieldCollector(fields, "drop."));
    if (!shared.config.empty()) read_config(shared.config, fields);
    tabletop().objects = objects.value_or(tabletop().objects);
    tabletop().seed = seed.value_or(tabletop().seed);
    camera().frames = frames.value_or(camera().frames);
    sequence ? sweep.validate() : scan.validate();
    drop().validate();
    return fields;
  }

  /// Scanned meshes that fell onto the table, or household objects put there.
  Tabletop furnish(StageTimer& timer) {
    if (meshes.empty()) {
      if (!symmetries.empty())
        throw InputError("--symmetries", "--meshes, whose symmetries they are", "none");
      return timer.time("arrange", [&] { return arrange_tabletop(tabletop()); });
    }
    const std::vector<ObjectModel> models =
        timer.time("read", [&] { return read_models(meshes, symmetries); });
    return timer.time("drop", [&] {
      return naming(meshes, [&] { return drop_tabletop(models, tabletop(), drop()); });
    });
  }

  void scan_table(const OptionFields& fields, Session& session, StageTimer& timer) {
    const Tabletop table = furnish(timer);
    const SimulatedScene simulated = timer.time(
        "simulate", [&] { return fuse_frames(table, capture_frames(table, scan), scan); });
    timer.time("write", [&] {
      write_scene(absolute(shared.output), simulated.scene,
                  {.scene_json = describe_run("simulate", fields), .truth = &simulated.truth});
    });
    const Index points = simulated.scene.cloud.size();
    const std::size_t count = simulated.truth.objects.size();
    session.say(fmt::format("{}: {} objects, {} points", shared.output.string(), count, points));
    session.finish({{"output", shared.output}, {"objects", count}, {"points", points}},
                   timer.stages());
  }

  void sweep_table(const OptionFields& fields, Session& session, StageTimer& timer) {
    SequenceWriter writer(absolute(shared.output), sweep.camera.intrinsics());
    const Tabletop table = furnish(timer);
    timer.time("frames", [&] {
      int number = 0;
      capture_sweep(table, sweep, [&](const DepthFrame& frame, const Eigen::Isometry3d& pose) {
        session.on_begin()(fmt::format("frame {} of {}", ++number, sweep.camera.frames));
        writer.add(frame, &pose);
      });
    });
    timer.time("write", [&] {
      write_truth_files(table, writer);
      writer.add_file("sequence.json", describe_run("simulate", fields));
      writer.finish();
    });
    const std::size_t count = table.objects.size();
    const auto taken = static_cast<std::uint64_t>(sweep.camera.frames);
    session.say(fmt::format("{}: {} objects, {} frames", shared.output.string(), count, taken));
    session.finish({{"output", shared.output}, {"objects", count}, {"frames", taken}},
                   timer.stages());
  }

  /// With the meshes beside it the truth of a sequence needs no other folder.
  static void write_truth_files(const Tabletop& table, SequenceWriter& writer) {
    const SceneTruth truth = tabletop_truth(table);
    for (std::size_t k = 0; k < table.objects.size(); ++k) {
      writer.add_file(fmt::format("meshes/{}.ply", truth.objects[k].mesh),
                      format_ply(table.objects[k].object.mesh));
    }
    writer.add_file("truth.json", format_truth(truth));
  }

  void run() {
    const OptionFields fields = configure();
    if (!meshes.empty()) require_not_input(shared.output, meshes);
    Session session("simulate", shared);
    StageTimer timer(session.on_begin());
    sequence ? sweep_table(fields, session, timer) : scan_table(fields, session, timer);
  }
};

}  // namespace

void add_simulate(CLI::App& app) {
  const auto state = std::make_shared<Simulate>();
  Arguments arguments(app, "simulate", "Scan a simulated table with objects, with the truth beside",
                      "symscene simulate -o scene --objects 6 --seed 1\n"
                      "  symscene simulate --sequence -o sweep --meshes ycb --seed 2");
  arguments.required_output(state->shared, "scene or sequence folder to write");
  arguments.flag("--sequence", state->sequence,
                 "write the noisy depth frames of a hand-held sweep, and do not fuse them");
  arguments.folder("--meshes", state->meshes,
                   "drop meshes of this folder onto the table, in place of household objects");
  arguments.file("--symmetries", state->symmetries, "JSON file with the symmetries of the meshes");
  arguments.count("--objects", state->objects, "objects on the table (default 6)");
  arguments.count("--frames", state->frames, "frames (default 20, with --sequence 200)");
  arguments.seed(state->seed);
  arguments.threads(state->shared);
  arguments.reporting(state->shared);
  arguments.config(state->shared, [state] { return state->configure(); });
  arguments.run([state] { state->run(); });
}

}  // namespace symscene::app
